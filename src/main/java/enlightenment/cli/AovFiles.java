package enlightenment.cli;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.render.Auxiliary;
import enlightenment.render.AuxiliaryPicture;
import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;

/** The further files beside a picture, {@code out.error.png} beside {@code out.png}. */
final class AovFiles {
    private final Map<Auxiliary, Path> files = new EnumMap<>(Auxiliary.class);

    /**
     * @param words what {@code --aov} says, or null if it is not given
     * @param output the picture
     */
    AovFiles(String words, Path output) {
        if (words == null) {
            return;
        }
        for (String word : words.split(",", -1)) {
            OptionValues.word("--aov", word, Auxiliary.words().toArray(new String[0]));
            Auxiliary kind = Auxiliary.of(word).orElseThrow();
            if (files.put(kind, beside(output, word)) != null) {
                throw CliException.wrongUsage("--aov names " + word + " twice");
            }
        }
    }

    private static Path beside(Path output, String word) {
        String name = output.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return output.resolveSibling(name.substring(0, dot) + "." + word + name.substring(dot));
    }

    /** What is asked for. */
    Set<Auxiliary> kinds() {
        Set<Auxiliary> kinds = EnumSet.noneOf(Auxiliary.class);
        kinds.addAll(files.keySet());
        return kinds;
    }

    /** Says that all of them will be written. */
    void register(OutputFiles outputs) {
        files.forEach((kind, file) -> outputs.writes("--aov " + kind.word(), file));
    }

    /** Writes all of them: pictures as PNG, raw numbers as PFM. */
    void write(Map<Auxiliary, Image> numbers, PngOptions options) throws IOException {
        for (Map.Entry<Auxiliary, Path> e : files.entrySet()) {
            Image raw = numbers.get(e.getKey());
            if (OutputFile.extension(e.getValue()).equals(".pfm")) {
                ImageFiles.writePfm(raw, e.getValue());
            } else {
                AuxiliaryPicture picture = AuxiliaryPicture.of(e.getKey(), raw);
                ImageFiles.writePng(picture.image(), e.getValue(), options.withText("Comment", picture.explanation()));
            }
        }
    }
}
