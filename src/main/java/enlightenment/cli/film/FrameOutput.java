package enlightenment.cli.film;

import enlightenment.cli.picture.AovFiles;
import enlightenment.cli.picture.AovSet;
import enlightenment.cli.picture.PictureOutput;
import enlightenment.render.RenderRequest;
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
            converter = PictureOutput.PngDepths.class,
            completionCandidates = PictureOutput.PngDepths.class,
            description = "bits per component of the PNG files: 8 (default) or 16")
    private Integer depth;

    @Option(
            names = "--overwrite",
            description = "make files anew that are there, but were made otherwise; without it they are an error")
    private boolean overwrite;

    @Option(
            names = "--aov",
            paramLabel = "LIST",
            converter = AovSet.Converter.class,
            completionCandidates = AovSet.Words.class,
            description = "write further files beside each frame: some of ${COMPLETION-CANDIDATES}, with commas")
    private AovSet aov = AovSet.EMPTY;

    FrameOutput() {}

    /** The auxiliary images that are written of each frame. */
    AovSet aov() {
        return aov;
    }

    /** The further files beside a frame. */
    AovFiles beside(int frame) {
        return new AovFiles(aov, pattern.file(frame));
    }

    FramePattern pattern() {
        return pattern;
    }

    /** The folder for a frame that is too large for the memory. */
    RenderRequest.ScratchFolder scratch() {
        return RenderRequest.ScratchFolder.of(pattern.folder().toAbsolutePath());
    }

    /** Bits per component. */
    int depth() {
        return depth == null ? PictureOutput.USUAL_DEPTH : depth;
    }

    boolean overwrites() {
        return overwrite;
    }
}
