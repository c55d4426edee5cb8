package enlightenment.cli;

import enlightenment.file.FilePlace;
import enlightenment.file.TemporaryFile;
import enlightenment.material.Texture;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * All files that a command reads and writes, checked once before anything is written: no output is an input or another output,
 * by whatever path, and all can be written.
 */
final class OutputFiles {
    /** Outputs that may go to standard output. */
    private static final Set<String> MAY_BE_STREAMS = Set.of("-o", "OUT.json");

    private final List<Named> inputs = new ArrayList<>();
    private final List<Named> outputs = new ArrayList<>();

    /** A file, and what it is to the user: of an output its option, of an input a few words. */
    private record Named(String what, Path file, boolean isChecked) {}

    /** The command reads this file, if it is not null. */
    OutputFiles reads(String what, Path file) {
        if (file != null && !Standard.is(file)) {
            inputs.add(new Named(what, file, false));
        }
        return this;
    }

    /** The command reads this scene, with the image files of its textures. */
    OutputFiles reads(Path file, Scene scene) {
        reads("the scene", file);
        scene.textures().forEach((name, texture) -> {
            if (texture instanceof Texture.File image) {
                reads("the image of texture \"" + name + "\"", image.file());
            }
        });
        return this;
    }

    /** The option, if its file is not null, makes the command write that file. */
    OutputFiles writes(String option, Path file) {
        return add(option, file, true);
    }

    /** The same for a file that is made if there is none, and is not touched otherwise; whoever makes it tells what is wrong. */
    OutputFiles makes(String option, Path file) {
        return add(option, file, false);
    }

    /** The same for files in a folder that is made if need be. */
    OutputFiles writes(String option, Path folder, List<String> names) {
        names.forEach(name -> add(option, folder.resolve(name), false));
        return this;
    }

    private OutputFiles add(String option, Path file, boolean isChecked) {
        boolean isStream = file != null && Standard.is(file) && MAY_BE_STREAMS.contains(option);
        if (file != null && !isStream) {
            outputs.add(new Named(option, file, isChecked));
        }
        return this;
    }

    /** Fails if a file would be written over; removes what killed processes have left beside the outputs. */
    void check() throws IOException {
        for (int i = 0; i < outputs.size(); i++) {
            Named output = outputs.get(i);
            for (Named input : inputs) {
                if (isOneFile(output, input)) {
                    throw CliException.wrongUsage(
                            output.what + " would write over " + input.what + ", " + spelled(input.file, output.file));
                }
            }
            for (Named other : outputs.subList(0, i)) {
                if (isOneFile(output, other)) {
                    throw CliException.wrongUsage(other.what + " and " + output.what + " would write the same file, "
                            + spelled(other.file, output.file));
                }
            }
        }
        for (Named output : outputs) {
            Path folder = FilePlace.of(output.file).getParent();
            if (output.isChecked) {
                OutputFile.check(output.file);
                if (!Files.exists(output.file) && !Files.isWritable(folder)) {
                    throw CliException.failed(output.file + ": cannot be written: it is a link to where nothing can be"
                            + " written, " + folder);
                }
            }
            if (folder != null && Files.isDirectory(folder)) {
                TemporaryFile.clean(folder);
            }
        }
    }

    /** Devices and pipes may be written to as often as one likes. */
    private static boolean isOneFile(Named a, Named b) throws IOException {
        boolean isDevice = Files.exists(a.file) && !Files.isRegularFile(a.file) && !Files.isDirectory(a.file);
        return !isDevice && FilePlace.same(a.file, b.file);
    }

    private static String spelled(Path a, Path b) {
        return a.equals(b) ? "\"" + a + "\"" : "\"" + a + "\", by the name \"" + b + "\"";
    }
}
