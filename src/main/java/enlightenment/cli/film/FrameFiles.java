package enlightenment.cli.film;

import enlightenment.cli.input.FrameChoice;
import enlightenment.cli.terminal.CliException;
import enlightenment.video.VideoFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
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
    /** Returns the digest that identifies a frame's picture. */
    @FunctionalInterface
    interface Expected {
        String digest(int frame) throws IOException;
    }

    /** @throws CliException if files would be overwritten that must not be */
    static FrameFiles of(FrameOutput output, FrameRange range, Expected expected) throws IOException {
        List<Integer> kept = new ArrayList<>();
        List<Integer> missing = new ArrayList<>();
        List<Integer> others = new ArrayList<>();
        Path first = null;
        for (int frame = range.first(); frame <= range.last(); frame++) {
            List<Path> all = new ArrayList<>(List.of(output.pattern().file(frame)));
            all.addAll(output.beside(frame).files());
            List<Path> there = all.stream().filter(Files::exists).toList();
            Path other = there.isEmpty() ? null : firstOther(there, expected.digest(frame));
            if (other == null && there.size() == all.size()) {
                kept.add(frame);
                continue;
            }
            missing.add(frame);
            if (other != null) {
                others.add(frame);
                first = first == null ? other : first;
            }
        }
        if (!others.isEmpty() && !output.overwrites()) {
            throw CliException.wrongUsage(told(first, others));
        }
        return new FrameFiles(kept, missing);
    }

    /** The first of the files that was made otherwise; null if there is none. */
    private static Path firstOther(List<Path> files, String digest) {
        return files.stream()
                .filter(file -> !VideoFile.comment(file, FrameDigest.KEYWORD).equals(Optional.of(digest)))
                .findFirst()
                .orElse(null);
    }

    private static String told(Path first, List<Integer> others) {
        String many = others.size() == 1
                ? "is there already, and was"
                : "and " + (others.size() - 1) + " more files (of frames " + FrameChoice.ranges(others)
                        + ") are there already, and were";
        return first + " " + many + " not made of this scene with these settings by this version: --overwrite replaces"
                + " them, another -o leaves them alone";
    }
}
