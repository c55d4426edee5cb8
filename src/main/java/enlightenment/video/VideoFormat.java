package enlightenment.video;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** The kinds of files that films can be written to. */
public enum VideoFormat {
    /** Animated PNG: exactly the frames, compressed as they are. Written without help. */
    APNG(List.of("apng", "png"), false, "", List.of()),

    /** GIF: 256 colours. By ffmpeg one set of colours for the whole film, dithered; by the JDK a set for each frame. */
    GIF(List.of("gif"), false, "gif", List.of("-f", "gif")),

    /** H.264 in MPEG-4, as browsers and telephones play it. */
    MP4(List.of("mp4"), true, "libx264", Ffmpeg.H264),

    /** VP9 in WebM. */
    WEBM(List.of("webm"), true, "libvpx-vp9", Ffmpeg.VP9),

    /** FFV1 in Matroska: exactly the frames, for further work. */
    MKV(List.of("mkv"), true, "ffv1", Ffmpeg.FFV1);

    private final List<String> extensions;
    private final boolean needsFfmpeg;
    private final String encoder;
    private final List<String> arguments;

    VideoFormat(List<String> extensions, boolean needsFfmpeg, String encoder, List<String> arguments) {
        this.extensions = extensions;
        this.needsFfmpeg = needsFfmpeg;
        this.encoder = encoder;
        this.arguments = arguments;
    }

    /** Whether nothing but ffmpeg can write it here. */
    public boolean needsFfmpeg() {
        return needsFfmpeg;
    }

    /** Whether ffmpeg writes it where there is one. */
    public boolean usesFfmpeg() {
        return !encoder.isEmpty();
    }

    /** What ffmpeg calls the encoder. */
    String encoder() {
        return encoder;
    }

    /** The name of a file of this kind. */
    String fileName() {
        return "film." + extensions.get(0);
    }

    /** The arguments of ffmpeg between input and output. */
    List<String> arguments() {
        return arguments;
    }

    /** The format of a file's name; empty if it has another ending. */
    public static Optional<VideoFormat> of(String fileName) {
        String name = fileName.toLowerCase(Locale.ROOT);
        return Arrays.stream(values())
                .filter(f -> f.extensions.stream().anyMatch(e -> name.endsWith("." + e)))
                .findFirst();
    }

    /** All endings that there are, as a message lists them. */
    public static String endings() {
        return Arrays.stream(values())
                .flatMap(f -> f.extensions.stream())
                .map(e -> "." + e)
                .collect(Collectors.joining(", "));
    }
}
