package enlightenment.scene;

import enlightenment.check.Check;
import java.math.BigDecimal;
import java.util.List;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * How a scene changes over its frames.
 *
 * @param frames the number of frames, at least 1; they are numbered from 0
 * @param framesPerSecond greater than 0
 * @param tracks what changes
 */
public record Animation(int frames, double framesPerSecond, List<Track> tracks) {
    /** @throws enlightenment.math.InvalidValueException if there are no frames, or framesPerSecond is not positive and finite */
    public Animation {
        Check.that(frames >= 1, "frames", "must be at least 1, not " + frames);
        Check.positive("framesPerSecond", framesPerSecond);
        tracks = List.copyOf(tracks);
    }

    /**
     * One changing number.
     *
     * @param target a JSON pointer to a number of the scene file
     * @param keys exact values at some frames, at least one, counted from 0; linear between them, constant before the first and after the last
     */
    public record Track(String target, NavigableMap<Integer, BigDecimal> keys) {
        public Track {
            Check.that(!keys.isEmpty(), "keys", "must hold at least one frame");
            keys = java.util.Collections.unmodifiableNavigableMap(new TreeMap<>(keys));
        }
    }
}
