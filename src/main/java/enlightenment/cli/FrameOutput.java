package enlightenment.cli;

import picocli.CommandLine.Option;

/** The options that say where frames are written, and how. */
final class FrameOutput {
    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "PATTERN",
            converter = FramePattern.Converter.class,
            description = "the files of frames, such as frames/frame-%%04d.png; the folder is made if need be")
    private FramePattern pattern;

    @Option(
            names = "--depth",
            paramLabel = "BITS",
            converter = PictureOutput.Depths.class,
            completionCandidates = PictureOutput.Depths.class,
            description = "bits per component of the PNG files: 8 (default) or 16")
    private Integer depth;

    @Option(
            names = "--overwrite",
            description = "make files anew that are there, but were made otherwise; without it they are an error")
    private boolean overwrite;

    FrameOutput() {}

    FramePattern pattern() {
        return pattern;
    }

    /** Bits per component. */
    int depth() {
        return depth == null ? PictureOutput.USUAL_DEPTH : depth;
    }

    boolean overwrites() {
        return overwrite;
    }
}
