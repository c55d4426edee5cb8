package enlightenment.cli.option;

import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.file.FilePlace;
import enlightenment.file.TemporaryFile;
import enlightenment.light.Light;
import enlightenment.material.Texture;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * All files that a command reads and writes, checked once before anything is written: no output is an input or another output,
 * by whatever path, and all can be written, so that an hour's render does not end in a wrong folder.
 */
public final class CommandFiles {
    /** Outputs that may go to standard output. */
    private static final Set<String> MAY_BE_STREAMS = Set.of("-o", "OUT.json");

    private final List<Named> inputs = new ArrayList<>();
    private final List<Named> outputs = new ArrayList<>();

    /** Outputs of one folder whose names are known to differ. */
    private final List<Named> numbered = new ArrayList<>();

    /** A file, and what it is to the user: of an output its option, of an input a few words. */
    private record Named(String what, Path file, boolean isChecked) {}

    /** The command reads this file, if it is not null; "-" is what standard input is open on. */
    public CommandFiles reads(String what, Path file) {
        if (file != null && StandardStreams.isNamed(file)) {
            StandardStreams.inputFile().ifPresent(open -> inputs.add(new Named(what, open, false)));
        } else if (file != null) {
            inputs.add(new Named(what, file, false));
        }
        return this;
    }

    /** The command reads this scene, with the image files of its textures and the IES files of its lights. */
    public CommandFiles reads(Path file, Scene scene) {
        reads("the scene", file);
        scene.textures().forEach((name, texture) -> {
            if (texture instanceof Texture.File image) {
                reads("the image of texture \"" + name + "\"", image.file());
            }
        });
        for (Light light : scene.lights()) {
            if (light instanceof Light.Ies luminaire) {
                reads("the IES file of a light", luminaire.file());
            }
        }
        return this;
    }

    /** The option, if its file is not null, makes the command write that file. */
    public CommandFiles writes(String option, Path file) {
        return add(option, file, true);
    }

    /** Adds a file that is made if there is none, and is not changed otherwise. The code that makes it reports failures. */
    public CommandFiles makes(String option, Path file) {
        return add(option, file, false);
    }

    /** Adds files in a folder that is made if need be. */
    public CommandFiles writes(String option, Path folder, List<String> names) {
        names.forEach(name -> add(option, folder.resolve(name), false));
        return this;
    }

    /** Adds files of one folder whose names differ by a number. */
    public CommandFiles writesNumbered(String option, List<Path> files) {
        files.forEach(file -> numbered.add(new Named(option, file, false)));
        return this;
    }

    private CommandFiles add(String option, Path file, boolean isChecked) {
        boolean isStream = file != null && StandardStreams.isNamed(file) && MAY_BE_STREAMS.contains(option);
        if (file != null && !isStream) {
            outputs.add(new Named(option, file, isChecked));
        }
        return this;
    }

    /** Fails if a file would be written over; removes what killed processes have left beside the outputs. */
    public void check() throws IOException {
        for (int i = 0; i < outputs.size(); i++) {
            checkInputs(outputs.get(i));
            checkOutputs(outputs.get(i), outputs.subList(0, i));
        }
        for (Named output : numbered) {
            checkOutputs(output, outputs);
            if (Files.exists(output.file)) {
                checkInputs(output);
            }
        }
        checkNumbered();
        for (Named output : outputs) {
            if (output.isChecked) {
                checkWritable(output.file);
            }
            clean(output);
        }
        if (!numbered.isEmpty()) {
            clean(numbered.get(0));
        }
    }

    /** Their names differ, but some may be links to others. */
    private void checkNumbered() throws IOException {
        if (numbered.stream().noneMatch(output -> Files.isSymbolicLink(output.file))) {
            return;
        }
        Map<Path, Named> places = new HashMap<>();
        for (Named output : numbered) {
            Named other = places.put(FilePlace.of(output.file), output);
            if (other != null) {
                checkOutputs(output, List.of(other));
            }
        }
    }

    private static void clean(Named output) throws IOException {
        Path folder = FilePlace.of(output.file).getParent();
        if (!isDevice(output.file) && folder != null && Files.isDirectory(folder)) {
            TemporaryFile.clean(folder);
        }
    }

    private void checkInputs(Named output) throws IOException {
        for (Named input : inputs) {
            if (isOneFile(output, input)) {
                boolean isStandardInput =
                        StandardStreams.inputFile().filter(input.file::equals).isPresent();
                throw CliException.wrongUsage(output.what + " would write over " + input.what + ", "
                        + (isStandardInput
                                ? "\"" + output.file + "\", which " + StandardStreams.INPUT + " reads"
                                : spelled(input.file, output.file)));
            }
        }
    }

    private static void checkOutputs(Named output, List<Named> others) throws IOException {
        for (Named other : others) {
            if (isOneFile(output, other)) {
                throw CliException.wrongUsage(other.what + " and " + output.what + " would write the same file, "
                        + spelled(other.file, output.file));
            }
        }
    }

    /** Devices and pipes may be written to as often as one likes. */
    private static boolean isOneFile(Named a, Named b) throws IOException {
        return !isDevice(a.file) && FilePlace.same(a.file, b.file);
    }

    /** Whether a path leads to something that is written into as it is, a device or a pipe, and never replaced. */
    public static boolean isDevice(Path file) {
        return Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file);
    }

    private static String spelled(Path a, Path b) {
        return a.equals(b) ? "\"" + a + "\"" : "\"" + a + "\", by the name \"" + b + "\"";
    }

    /** Fails unless the file can be written, as far as can be told without trying. */
    private static void checkWritable(Path file) throws IOException {
        if (StandardStreams.isNamed(file)) {
            throw CliException.wrongUsage(
                    "only the picture (-o) can go to standard output, \"-\"; \"./-\" is a file of that name");
        }
        if (Files.isDirectory(file)) {
            throw unwritable(file, "it is a folder");
        }
        if (Files.exists(file) && !Files.isWritable(file)) {
            throw unwritable(file, "it is write-protected");
        }
        if (isDevice(file)) {
            // It is written into as it is: nothing is made in its folder.
            return;
        }
        Path folder = file.toAbsolutePath().getParent();
        if (folder == null || !Files.exists(folder)) {
            throw unwritable(file, "there is no folder " + folder);
        }
        if (!Files.isDirectory(folder)) {
            throw unwritable(file, folder + " is not a folder");
        }
        if (!Files.isWritable(folder)) {
            throw unwritable(file, "no permission to write to the folder " + folder);
        }
        Path target = FilePlace.of(file).getParent();
        if (!Files.exists(file) && !Files.isWritable(target)) {
            throw unwritable(file, "it is a link to where nothing can be written, " + target);
        }
    }

    private static CliException unwritable(Path file, String reason) {
        return CliException.failed(file + ": cannot be written: " + reason);
    }
}
