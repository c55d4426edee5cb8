package enlightenment.cli.film;

import enlightenment.cli.input.FrameChoice;
import enlightenment.cli.terminal.Terminal;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;

/** Prints notes about a film's frames. Each appears at the first frame that it concerns, and at the end for how many more. */
final class FilmNotes {
    private final Terminal terminal;
    private final Map<String, TreeSet<Integer>> frames = new LinkedHashMap<>();

    FilmNotes(Terminal terminal) {
        this.terminal = terminal;
    }

    /** Prints a note about a frame, unless it was printed for another one. */
    void say(int frame, String text) {
        say(frame, text, text);
    }

    /**
     * Prints a note about a frame, unless one of this kind was printed for another frame.
     *
     * @param kind the part of the note that all frames of the kind have in common
     * @param text the note about this frame
     */
    synchronized void say(int frame, String kind, String text) {
        TreeSet<Integer> concerned = frames.computeIfAbsent(kind, k -> new TreeSet<>());
        if (concerned.isEmpty()) {
            terminal.say(FrameWriter.named(frame) + text);
        }
        concerned.add(frame);
    }

    /**
     * Prints which other frames each note concerns.
     *
     * @param all the number of frames that were made
     */
    synchronized void finish(int all) {
        frames.forEach((kind, concerned) -> {
            int n = concerned.size();
            if (n > 1) {
                String which = n == all
                        ? "all " + n + " frames"
                        : n + " frames, " + FrameChoice.ranges(List.copyOf(concerned));
                terminal.say(which + ": " + kind);
            }
        });
        frames.clear();
    }
}
