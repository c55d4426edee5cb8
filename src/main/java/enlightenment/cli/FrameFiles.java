package enlightenment.cli;

import enlightenment.video.VideoFile;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Which frames are there already. A file that holds the frame as it would be made now is kept: it says so itself. Any other is not
 * touched unless that is wanted.
 *
 * @param kept the frames whose files stay
 * @param missing the frames to be rendered, in order
 */
record FrameFiles(List<Integer> kept, List<Integer> missing) {
    /** What tells a frame's picture from others. */
    @FunctionalInterface
    interface Expected {
        String digest(int frame) throws IOException;
    }

    /** @throws CliException if files would be overwritten that must not be */
    static FrameFiles of(FrameOutput output, FrameRange range, Expected expected) throws IOException {
        List<Integer> kept = new ArrayList<>();
        List<Integer> missing = new ArrayList<>();
        List<Integer> others = new ArrayList<>();
        for (int frame = range.first(); frame <= range.last(); frame++) {
            if (!Files.exists(output.pattern().file(frame))) {
                missing.add(frame);
            } else if (said(output, frame).equals(Optional.of(expected.digest(frame)))) {
                kept.add(frame);
            } else {
                missing.add(frame);
                others.add(frame);
            }
        }
        if (!others.isEmpty() && !output.overwrites()) {
            throw CliException.wrongUsage(told(output, others));
        }
        return new FrameFiles(kept, missing);
    }

    private static Optional<String> said(FrameOutput output, int frame) {
        return VideoFile.comment(output.pattern().file(frame), FrameDigest.KEYWORD);
    }

    private static String told(FrameOutput output, List<Integer> others) {
        String first = output.pattern().file(others.get(0)).toString();
        String many = others.size() == 1
                ? "is there already, and was"
                : "and " + (others.size() - 1) + " more files (of frames " + FrameChoice.ranges(others)
                        + ") are there already, and were";
        return first + " " + many + " not made of this scene with these settings by this version: --overwrite replaces"
                + " them, another -o leaves them alone";
    }
}
