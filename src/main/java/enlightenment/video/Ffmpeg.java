package enlightenment.video;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.regex.Pattern;

/**
 * The program {@code ffmpeg}, which is called with a list of arguments, never through a shell. It reads the frames from its
 * standard input and writes into a folder of ours under a name of ours: nothing that a user or a scene called something is
 * interpreted by it, but the folder's own path, which is absolute.
 */
public final class Ffmpeg {
    /** Colours of screens: BT.709 with sRGB's curve, and said so; players guess otherwise, differently. */
    private static final String COLORS = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";

    private static final List<String> SAID = List.of(
            "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv");

    /** Sides that are odd become even, since colours are kept for two by two pixels. */
    static final List<String> H264 = with(
            SAID,
            "-vf",
            "pad=ceil(iw/2)*2:ceil(ih/2)*2," + COLORS,
            "-c:v",
            "libx264",
            "-crf",
            "18",
            "-preset",
            "medium",
            "-movflags",
            "+faststart",
            "-f",
            "mp4");

    static final List<String> VP9 =
            with(SAID, "-vf", COLORS, "-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0", "-row-mt", "1", "-f", "webm");

    static final List<String> FFV1 = List.of("-c:v", "ffv1", "-level", "3", "-f", "matroska");

    /** The last of what it says is what matters. */
    private static final int MOST_TOLD = 2000;

    private static final String PALETTE = "palette.png";

    private final String program;

    private Ffmpeg(String program) {
        this.program = program;
    }

    private static List<String> with(List<String> some, String... more) {
        List<String> all = new ArrayList<>(List.of(more));
        all.addAll(some);
        return List.copyOf(all);
    }

    /** The program in this file. */
    public static Ffmpeg at(Path file) {
        return new Ffmpeg(file.toAbsolutePath().toString());
    }

    /**
     * The first in the folders of a search path; those that are not absolute are left out, so that what lies in the working folder is
     * never run unasked.
     *
     * @param searchPath the environment's {@code PATH}, or null
     */
    public static Optional<Ffmpeg> onPath(String searchPath) {
        boolean isWindows = File.separatorChar == '\\';
        for (String folder : (searchPath == null ? "" : searchPath).split(Pattern.quote(File.pathSeparator))) {
            try {
                Path file = Path.of(folder, isWindows ? "ffmpeg.exe" : "ffmpeg");
                if (file.isAbsolute() && Files.isRegularFile(file) && Files.isExecutable(file)) {
                    return Optional.of(at(file));
                }
            } catch (InvalidPathException e) {
                continue;
            }
        }
        return Optional.empty();
    }

    /** The file that is run. */
    public Path file() {
        return Path.of(program);
    }

    /**
     * Asks the program whether it can write this, before frames are made for hours.
     *
     * @throws IOException with a message, if it cannot, or is not ffmpeg
     */
    public void check(VideoFormat format, BooleanSupplier cancelled) throws IOException {
        ToolRun run = ToolRun.start(List.of(program, "-hide_banner", "-nostdin", "-encoders"), cancelled);
        int code = run.await();
        if (code != 0 || !run.output().contains("Encoders:")) {
            throw new IOException(
                    program + " does not answer as ffmpeg does (exit code " + code + ")" + told(run.errors()));
        }
        boolean known = run.output()
                .lines()
                .map(String::strip)
                .anyMatch(line -> line.matches("[A-Z.]{6} +" + Pattern.quote(format.encoder()) + " .*"));
        if (!known) {
            throw new IOException(program + " was built without the encoder " + format.encoder() + ", which "
                    + format.name() + " files need");
        }
    }

    /**
     * Writes the film into a folder of ours.
     *
     * @return its file
     */
    Path write(VideoFile film, VideoFormat format, Path folder) throws IOException {
        Path out = folder.resolve(format.fileName());
        if (format == VideoFormat.GIF) {
            // In two goes: in one, ffmpeg keeps all frames in memory until it knows their colours.
            Path palette = folder.resolve(PALETTE);
            feed(film, input(film), List.of("-vf", "palettegen", "-f", "image2", "-update", "1", palette.toString()));
            List<String> input = new ArrayList<>(input(film));
            input.addAll(List.of("-i", palette.toString()));
            feed(film, input, List.of("-lavfi", "paletteuse", "-f", "gif", out.toString()));
        } else {
            List<String> output = new ArrayList<>(format.arguments());
            output.add(out.toString());
            feed(film, input(film), output);
        }
        return out;
    }

    private static List<String> input(VideoFile film) {
        return List.of(
                "-f", "image2pipe", "-c:v", "png", "-framerate", film.rate().toString(), "-i", "pipe:0");
    }

    /** The command that does the same by hand with the files of frames. */
    public static List<String> byHand(VideoFormat format, FrameRate rate, String pattern, int first, Path out) {
        List<String> command = new ArrayList<>(List.of("ffmpeg", "-framerate", rate.toString(), "-start_number"));
        command.addAll(List.of(Integer.toString(first), "-i", pattern));
        command.addAll(format.arguments());
        command.add(out.toString().startsWith("-") ? "./" + out : out.toString());
        return command;
    }

    private void feed(VideoFile film, List<String> input, List<String> output) throws IOException {
        List<String> command =
                new ArrayList<>(List.of(program, "-hide_banner", "-nostats", "-loglevel", "error", "-y"));
        command.addAll(input);
        command.addAll(output);
        ToolRun run = ToolRun.start(command, film.cancelled());
        IOException broken = null;
        try (OutputStream frames = run.input()) {
            film.forEach(frames::write);
        } catch (IOException e) {
            // The program has ended, or a frame cannot be read: what the program says comes first.
            broken = e;
        } catch (RuntimeException e) {
            run.end();
            throw e;
        }
        int code = run.await();
        if (code != 0) {
            throw new IOException("ffmpeg failed (exit code " + code + ")" + told(run.errors()), broken);
        }
        if (broken != null) {
            throw broken;
        }
    }

    private static String told(String words) {
        String all = words.strip();
        String end = all.length() > MOST_TOLD ? "..." + all.substring(all.length() - MOST_TOLD) : all;
        return all.isEmpty() ? "" : ": " + end;
    }
}
