package enlightenment.cli.film;

import enlightenment.cli.input.FrameChoice;
import enlightenment.cli.terminal.Terminal;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;

/** What is to be said of a film's frames: each thing at the first frame that it concerns, and in the end of how many more. */
final class FilmNotes {
    private final Terminal terminal;
    private final Map<String, TreeSet<Integer>> frames = new LinkedHashMap<>();

    FilmNotes(Terminal terminal) {
        this.terminal = terminal;
    }

    /** Says something of a frame, unless it has been said of another one. */
    void say(int frame, String text) {
        say(frame, text, text);
    }

    /**
     * The same.
     *
     * @param kind what is the same of all frames of which it is said
     * @param text what is said of this one
     */
    synchronized void say(int frame, String kind, String text) {
        TreeSet<Integer> concerned = frames.computeIfAbsent(kind, k -> new TreeSet<>());
        if (concerned.isEmpty()) {
            terminal.say(FrameWriter.named(frame) + text);
        }
        concerned.add(frame);
    }

    /**
     * Says which frames what was said of one of them concerns too.
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
