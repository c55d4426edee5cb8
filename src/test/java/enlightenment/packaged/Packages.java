package enlightenment.packaged;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** What the build has made, and processes that use it. */
final class Packages {
    static final Path PROJECT = Path.of(System.getProperty("project.directory", "."));
    static final String VERSION = System.getProperty("project.version");
    static final Path LIBRARY = PROJECT.resolve("target").resolve("enlightenment-" + VERSION + ".jar");
    static final Path APPLICATION = PROJECT.resolve("target").resolve("enlightenment.jar");
    static final Path ZIP = PROJECT.resolve("target").resolve("enlightenment-" + VERSION + "-app.zip");
    static final Path SCENE = PROJECT.resolve("scenes").resolve("cone.json");
    static final Path JAVA = Path.of(System.getProperty("java.home"), "bin", "java");

    private Packages() {}

    /** The jars of dependencies, those of tests included. */
    static List<Path> dependencies() {
        return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .filter(entry -> entry.endsWith(".jar"))
                .map(Path::of)
                .filter(jar -> !jar.toAbsolutePath()
                        .startsWith(PROJECT.resolve("target").toAbsolutePath()))
                .toList();
    }

    /** The only dependency whose file name begins like this. */
    static Path dependency(String name) {
        List<Path> found = dependencies().stream()
                .filter(jar -> jar.getFileName().toString().startsWith(name))
                .toList();
        if (found.size() != 1) {
            throw new AssertionError(name + " is there " + found.size() + " times: " + found);
        }
        return found.get(0);
    }

    /**
     * What a process said and how it ended.
     *
     * @param code its exit code
     * @param out what it wrote to standard output
     * @param err what it wrote to standard error
     */
    record Run(int code, String out, String err) {
        @Override
        public String toString() {
            return "exit code " + code + "\n" + out + "\n" + err;
        }
    }

    /** Runs a process in a folder, with these variables besides those that are there; an empty one is removed. */
    static Run run(Path folder, Map<String, String> environment, Object... command)
            throws IOException, InterruptedException {
        ProcessBuilder builder =
                new ProcessBuilder(Arrays.stream(command).map(Object::toString).toList()).directory(folder.toFile());
        builder.environment()
                .keySet()
                .removeAll(List.of(
                        "JAVA_OPTS",
                        "ENLIGHTENMENT_OPTS",
                        "XDG_CACHE_HOME",
                        "JAVA_TOOL_OPTIONS",
                        "_JAVA_OPTIONS",
                        "JDK_JAVA_OPTIONS"));
        environment.forEach((name, value) -> {
            if (value.isEmpty()) {
                builder.environment().remove(name);
            } else {
                builder.environment().put(name, value);
            }
        });
        Path out = Files.createTempFile("out", ".txt");
        Path err = Files.createTempFile("err", ".txt");
        try {
            Process process = builder.redirectOutput(out.toFile())
                    .redirectError(err.toFile())
                    .start();
            process.getOutputStream().close();
            int code = process.waitFor();
            return new Run(code, text(out), text(err));
        } finally {
            Files.deleteIfExists(out);
            Files.deleteIfExists(err);
        }
    }

    private static String text(Path file) throws IOException {
        return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    }
}
