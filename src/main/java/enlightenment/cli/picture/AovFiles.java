package enlightenment.cli.picture;

import enlightenment.cli.option.CommandFiles;
import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.render.RenderResult;
import enlightenment.render.aov.AuxiliaryPicture;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;

/** The further files beside a picture, {@code out.error.png} beside {@code out.png}. */
public final class AovFiles {
    private final Map<RenderResult.Auxiliary, Path> files = new EnumMap<>(RenderResult.Auxiliary.class);

    /** @param picture the picture's file, with the extension of an image format if any kind is asked for */
    public AovFiles(AovSet kinds, Path picture) {
        kinds.kinds().forEach(kind -> files.put(kind, beside(picture, kind.word())));
    }

    private static Path beside(Path picture, String word) {
        String name = picture.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return picture.resolveSibling(name.substring(0, dot) + "." + word + name.substring(dot));
    }

    /** The files that will be written. */
    public Collection<Path> files() {
        return Collections.unmodifiableCollection(files.values());
    }

    /** Adds the files that will be written. */
    public void register(CommandFiles outputs) {
        files.forEach((kind, file) -> outputs.writes("--aov " + kind.word(), file));
    }

    /**
     * Writes all of them: raw numbers where the format holds floats, else pictures to look at.
     *
     * @param numbers what the render gave
     * @param shown the picture as it is shown: parts of its light are shown likewise
     */
    public void write(Map<RenderResult.Auxiliary, Image> numbers, Image shown, ImageFiles.PngOptions options)
            throws IOException {
        for (Map.Entry<RenderResult.Auxiliary, Path> e : files.entrySet()) {
            Image raw = numbers.get(e.getKey());
            if (ImageFormat.ofExtension(e.getValue()).orElseThrow().holdsFloats()) {
                ImageFiles.write(raw, e.getValue(), options);
            } else {
                Image likewise = raw.encoding() == Color.Encoding.LINEAR ? raw.withCurve(shown.curve()) : raw;
                AuxiliaryPicture picture = AuxiliaryPicture.of(e.getKey(), likewise);
                ImageFiles.write(picture.image(), e.getValue(), options.withText("Comment", picture.explanation()));
            }
        }
    }
}
