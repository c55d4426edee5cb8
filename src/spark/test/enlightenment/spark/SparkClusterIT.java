package enlightenment.spark;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Clusters of one machine: a driver and two executors, each a process, started by what {@code spark-submit} starts. */
@Timeout(value = 10, unit = TimeUnit.MINUTES)
class SparkClusterIT {
    private static final Path PROJECT = Path.of(System.getProperty("project.directory"));
    private static final Path TARGET = PROJECT.resolve("target");
    private static final String JAVA =
            Path.of(System.getProperty("java.home"), "bin", "java").toString();
    private static final String SCENE =
            PROJECT.resolve("scenes").resolve("fire-and-ice.json").toString();
    private static final List<String> RENDER = List.of("--size", "400x200", "--samples", "800", "--progress", "none");

    /** A folder with Spark's jars is all of a Spark distribution that executors need. */
    private static final Path HOME = TARGET.resolve("spark-home");

    private static byte[] expected;

    @TempDir
    Path folder;

    private final List<Process> started = new ArrayList<>();

    @BeforeAll
    static void gather() throws Exception {
        Path jars = Files.createDirectories(HOME.resolve("jars"));
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            Path jar = Path.of(entry);
            Path link = jars.resolve(jar.getFileName());
            if (entry.endsWith(".jar") && !jar.startsWith(TARGET) && !Files.exists(link)) {
                Files.createSymbolicLink(link, jar);
            }
        }
        Path picture = TARGET.resolve("spark-expected.png");
        List<String> command = new ArrayList<>(
                List.of(JAVA, "-jar", TARGET.resolve("enlightenment.jar").toString(), "render", SCENE));
        command.addAll(List.of("-o", picture.toString()));
        command.addAll(RENDER);
        assertEquals(0, new ProcessBuilder(command).inheritIO().start().waitFor());
        expected = Files.readAllBytes(picture);
    }

    @AfterEach
    void endAll() {
        for (Process process : started) {
            List<ProcessHandle> children = process.descendants().toList();
            process.destroyForcibly();
            children.forEach(ProcessHandle::destroyForcibly);
        }
    }

    @Test
    void anExecutorKilledHalfWayDoesNotChangeTheBytes() throws Exception {
        Path log = TARGET.resolve("spark-executor-killed.log");
        Process driver = submit(log, "picture.png");
        awaitFinishedTasks(driver, log, 4);
        ProcessHandle executor = executors(driver).get(0);
        assertTrue(executor.destroyForcibly());
        assertEquals(0, driver.waitFor(), () -> text(log));
        assertTrue(text(log).contains("Lost executor"), () -> text(log));
        assertArrayEquals(expected, Files.readAllBytes(folder.resolve("picture.png")));
    }

    @Test
    void aDriverKilledHalfWayGoesOnFromItsCheckpoint() throws Exception {
        Path first = TARGET.resolve("spark-driver-killed.log");
        Process driver = submit(first, "picture.png", "--checkpoint", "picture.ck");
        awaitFinishedTasks(driver, first, 4);
        List<ProcessHandle> children = driver.descendants().toList();
        driver.destroyForcibly().waitFor();
        children.forEach(ProcessHandle::destroyForcibly);

        Path second = TARGET.resolve("spark-driver-again.log");
        Process again = submit(second, "picture.png", "--checkpoint", "picture.ck");
        assertEquals(0, again.waitFor(), () -> text(second));
        Matcher done = Pattern.compile("checkpoint: (\\d+) of (\\d+) tiles are done already")
                .matcher(text(second));
        assertTrue(done.find(), () -> text(second));
        assertTrue(Integer.parseInt(done.group(1)) > 0);
        assertTrue(Integer.parseInt(done.group(1)) < Integer.parseInt(done.group(2)));
        assertArrayEquals(expected, Files.readAllBytes(folder.resolve("picture.png")));
    }

    private Process submit(Path log, String picture, String... more) throws IOException {
        List<String> command = new ArrayList<>(List.of(JAVA));
        Stream.of(
                        "java.base/java.lang",
                        "java.base/java.lang.invoke",
                        "java.base/java.net",
                        "java.base/java.nio",
                        "java.base/java.util",
                        "java.base/java.util.concurrent",
                        "java.base/sun.nio.ch",
                        "java.base/sun.security.action")
                .forEach(p -> command.addAll(List.of("--add-opens", p + "=ALL-UNNAMED")));
        command.addAll(List.of("-cp", HOME.resolve("jars") + File.separator + "*"));
        command.addAll(List.of("org.apache.spark.deploy.SparkSubmit", "--master", "local-cluster[2,1,1024]"));
        command.addAll(List.of("--class", "enlightenment.cli.SparkCommand", "--conf", "spark.ui.enabled=false"));
        command.addAll(List.of("--jars", TARGET.resolve("enlightenment.jar").toString()));
        command.addAll(List.of(TARGET.resolve("enlightenment-spark.jar").toString(), SCENE, "-o", picture));
        command.addAll(RENDER);
        command.addAll(List.of(more));
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
        builder.environment().put("SPARK_HOME", HOME.toString());
        // What bin/load-spark-env.sh would do.
        builder.environment().put("SPARK_SCALA_VERSION", "2.13");
        builder.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
        Files.deleteIfExists(log);
        Process process =
                builder.redirectErrorStream(true).redirectOutput(log.toFile()).start();
        started.add(process);
        return process;
    }

    private static void awaitFinishedTasks(Process driver, Path log, int tasks) throws InterruptedException {
        while (text(log).split("Finished task", -1).length <= tasks) {
            if (!driver.isAlive()) {
                fail("ended before it could be disturbed:\n" + text(log));
            }
            Thread.sleep(50);
        }
    }

    private static List<ProcessHandle> executors(Process driver) {
        List<ProcessHandle> found = driver.descendants()
                .filter(p -> p.info().commandLine().orElse("").contains("CoarseGrainedExecutorBackend"))
                .toList();
        assertEquals(2, found.size());
        return found;
    }

    private static String text(Path log) {
        try {
            return Files.readString(log);
        } catch (IOException e) {
            return "";
        }
    }
}
