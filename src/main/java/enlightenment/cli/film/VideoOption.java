package enlightenment.cli.film;

import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Shell;
import enlightenment.cli.terminal.Terminal;
import enlightenment.video.Ffmpeg;
import enlightenment.video.FrameRate;
import enlightenment.video.VideoFile;
import enlightenment.video.VideoFormat;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import picocli.CommandLine.Option;

/** The options that make a film of frames. */
final class VideoOption {
    /** The clock of GIF files counts hundredths, and players take one of them for nothing said. */
    private static final double FASTEST_GIF = 50;

    @Option(
            names = "--video",
            paramLabel = "FILE",
            description = "write the frames as a film too: .apng (exact), .gif; .mp4, .webm or .mkv with ffmpeg")
    private Path video;

    @Option(
            names = "--ffmpeg",
            paramLabel = "FILE",
            description = "the ffmpeg program for --video, if not the one that is found on the PATH")
    private Path program;

    private VideoFormat format;
    private FrameRate rate;
    private Optional<Ffmpeg> ffmpeg = Optional.empty();

    VideoOption() {}

    /** The film's file, or null. */
    Path file() {
        return video;
    }

    /** The program that was named, or null. */
    Path program() {
        return program;
    }

    /** Fails if the film could not be written: before there are frames to make it of. */
    void check(double framesPerSecond, FramePattern pattern, FrameRange frames, Terminal terminal) {
        if (video == null) {
            return;
        }
        format = VideoFormat.of(video.toString())
                .orElseThrow(() -> CliException.wrongUsage(
                        "--video must name a file that ends in " + VideoFormat.endings() + ", not \"" + video + "\""));
        try {
            rate = FrameRate.of(framesPerSecond);
        } catch (IllegalArgumentException e) {
            throw CliException.wrongUsage("--video: " + e.getMessage());
        }
        if (format == VideoFormat.GIF && framesPerSecond > FASTEST_GIF) {
            terminal.say("warning: a .gif shows at most 50 frames a second; it will be slower than the film's "
                    + DecimalNumber.plain(framesPerSecond));
        }
        if (format.usesFfmpeg()) {
            ffmpeg = find();
            requireFfmpeg(pattern, frames);
            ask(terminal);
        }
    }

    private Optional<Ffmpeg> find() {
        if (program == null) {
            return Ffmpeg.onPath(System.getenv("PATH"));
        }
        if (!Files.isRegularFile(program) || !Files.isExecutable(program)) {
            throw CliException.wrongUsage("--ffmpeg: " + program + " is no program that can be run");
        }
        return Optional.of(Ffmpeg.at(program));
    }

    private void requireFfmpeg(FramePattern pattern, FrameRange frames) {
        if (ffmpeg.isEmpty() && format.needsFfmpeg()) {
            List<String> byHand = Ffmpeg.byHand(format, rate, pattern.toString(), frames.first(), video);
            throw CliException.wrongUsage("--video " + video + " needs ffmpeg, which is not on the PATH. Install it"
                    + " (Debian: apt-get install ffmpeg) or name it with --ffmpeg; .apng and .gif need none. Or make"
                    + " the frames without --video, and the film where there is ffmpeg:\n  "
                    + byHand.stream().map(Shell::quoted).collect(Collectors.joining(" ")));
        }
    }

    private void ask(Terminal terminal) {
        if (ffmpeg.isPresent()) {
            try {
                ffmpeg.get().check(format, terminal.stop());
            } catch (IOException e) {
                throw CliException.wrongUsage("--video " + video + ": " + e.getMessage());
            } catch (CancellationException e) {
                throw CliException.failed("stopped before anything was rendered");
            }
        }
    }

    /**
     * Writes the film, if it was asked for.
     *
     * @throws CancellationException if it was stopped
     */
    void write(List<Path> frames, Terminal terminal) throws IOException {
        if (video != null) {
            new VideoFile(frames, rate, terminal.stop()).write(video, format, ffmpeg);
        }
    }
}
