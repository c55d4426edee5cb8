package enlightenment.video;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Films by a real ffmpeg, played back by it; where there is none (Debian: package ffmpeg), these tests are left out. */
class RealFfmpegTest {
    private static final Optional<Ffmpeg> FOUND = Ffmpeg.onPath(System.getenv("PATH"));

    @TempDir
    Path folder;

    /** The frames of a film as bytes of red, green, blue. */
    private static byte[] played(Path film) throws IOException {
        Process process = new ProcessBuilder(List.of(
                        FOUND.orElseThrow().file().toString(),
                        "-nostdin",
                        "-loglevel",
                        "error",
                        "-i",
                        film.toString(),
                        "-fps_mode",
                        "passthrough",
                        "-f",
                        "rawvideo",
                        "-pix_fmt",
                        "rgb24",
                        "-"))
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        return process.getInputStream().readAllBytes();
    }

    /**
     * Of red, green and blue the mean of the differences from the frames, then the mean of all their squares, in steps of 1/255.
     */
    private static double[] differences(byte[] played, List<Path> frames) throws IOException {
        double[] sums = new double[4];
        int at = 0;
        for (Path frame : frames) {
            for (float component : ImageFiles.read(frame).toArray()) {
                double d = (played[at] & 255) - 255 * component;
                sums[at++ % 3] += 3 * d;
                sums[3] += d * d;
            }
        }
        int n = at;
        return DoubleStream.of(sums).map(sum -> sum / n).toArray();
    }

    /** Where colours are kept for two by two pixels, edges are blurred; but by the wrong matrix the mean of red would be ten steps off. */
    @ParameterizedTest
    @CsvSource({"MP4, 60, 2", "WEBM, 60, 2", "GIF, 60, 1", "MKV, 1e-9, 1e-6", "APNG, 1e-9, 1e-6"})
    void whatIsPlayedIsWhatWasRendered(VideoFormat format, double mostSquare, double mostMean) throws IOException {
        assumeTrue(FOUND.isPresent());
        Path out = folder.resolve("-a film: 50 %d.x");
        if (format.usesFfmpeg()) {
            FOUND.get().check(format, () -> false);
        }
        List<Path> frames = Frames.write(folder);
        new VideoFile(frames, FrameRate.of(25), () -> false).write(out, format, FOUND);
        byte[] played = played(out);
        assertEquals(3 * Frames.WIDTH * Frames.HEIGHT * Frames.COUNT, played.length);
        double[] differences = differences(played, frames);
        assertTrue(differences[3] <= mostSquare, "mean square " + differences[3]);
        for (int c = 0; c < 3; c++) {
            assertEquals(0, differences[c], mostMean, "component " + c);
        }
    }
}
