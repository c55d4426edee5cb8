package enlightenment.cli.input;

import enlightenment.scene.Animation;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.TreeSet;

/**
 * Which frames of an animation are checked: all of them, or, where that would take minutes, those with keys and others spread
 * evenly. Between keys numbers go one way, so that each has its minimum and its maximum in a frame with keys. A frame that several moments
 * make is read as often.
 *
 * @param frames the chosen ones, in order
 * @param all the number of frames of the animation
 */
public record FrameChoice(List<Integer> frames, int all) {
    /** The total length of text that is read in some seconds. */
    private static final long MAX_BYTES = 100_000_000;

    private static final int MAX_FRAMES = 2000;
    private static final int MIN_FRAMES = 20;
    private static final int MAX_RANGES = 10;

    /** @param bytes length of the scene's text */
    public static FrameChoice of(Animation animation, long bytes) {
        int all = animation.frames();
        int readings = animation.isBlurred() ? 1 + animation.instants() : 1;
        int most = (int) Math.max(Math.min(MAX_BYTES / Math.max(bytes, 1), MAX_FRAMES) / readings, MIN_FRAMES);
        TreeSet<Integer> chosen = new TreeSet<>();
        if (all > most) {
            addSpread(keys(animation, all), most / 2, chosen);
        }
        // Half of them, or all where they are few.
        int rest = all > most ? most - chosen.size() : all;
        for (int i = 0; i < rest; i++) {
            chosen.add(rest == 1 ? 0 : (int) ((long) i * (all - 1) / (rest - 1)));
        }
        return new FrameChoice(List.copyOf(chosen), all);
    }

    /** Frames with keys, the last frame for those beyond it. */
    private static List<Integer> keys(Animation animation, int all) {
        TreeSet<Integer> keys = new TreeSet<>();
        for (Animation.Track track : animation.tracks()) {
            track.keys().keySet().forEach(k -> keys.add(Math.min(Math.max(k, 0), all - 1)));
        }
        return List.copyOf(keys);
    }

    private static void addSpread(List<Integer> from, int most, Collection<Integer> to) {
        int count = Math.min(from.size(), most);
        for (int i = 0; i < count; i++) {
            to.add(from.get(count == 1 ? 0 : (int) ((long) i * (from.size() - 1) / (count - 1))));
        }
    }

    /** {@code all 401 frames}, or the number checked and the number of all. */
    public String inWords() {
        return frames.size() == all
                ? all == 1 ? "its only frame" : "all " + all + " frames"
                : frames.size() + " frames that were looked at, of " + all;
    }

    /** Numbers in order, neighbours put together: {@code 3, 7..12}. */
    public static String ranges(List<Integer> numbers) {
        List<String> ranges = new ArrayList<>();
        int from = 0;
        for (int i = 1; i <= numbers.size(); i++) {
            if (i == numbers.size() || numbers.get(i) != numbers.get(i - 1) + 1) {
                ranges.add(
                        from == i - 1 ? numbers.get(from).toString() : numbers.get(from) + ".." + numbers.get(i - 1));
                from = i;
            }
        }
        String shown = String.join(", ", ranges.subList(0, Math.min(ranges.size(), MAX_RANGES)));
        return ranges.size() > MAX_RANGES ? shown + " and more" : shown;
    }
}
