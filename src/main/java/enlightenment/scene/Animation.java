package enlightenment.scene;

import enlightenment.check.Check;
import java.math.BigDecimal;
import java.util.Collections;
import java.util.List;
import java.util.NavigableMap;
import java.util.Objects;
import java.util.TreeMap;

/**
 * How a scene changes from frame to frame: tracks, each of which moves one number of it.
 *
 * @param frames the number of frames, at least 1; they are numbered from 0
 * @param framesPerSecond greater than 0
 * @param tracks what changes
 * @param shutter how long the shutter is open in each frame, from the frame's time on, as a share of the time between two frames: 0 for
 *     pictures of a moment, or {@link #LEAST_SHUTTER}..1
 * @param instants how many moments a picture is made of while the shutter is open, evenly spaced, 1..{@link #MOST_INSTANTS}; without
 *     meaning if it is not open
 *
 */
public record Animation(int frames, double framesPerSecond, List<Track> tracks, double shutter, int instants) {
    /** As many as make smooth streaks of motions of some ten pixels. */
    public static final int USUAL_INSTANTS = 16;

    public static final int MOST_INSTANTS = 256;

    /** The shortest time that the shutter may be open. */
    public static final double LEAST_SHUTTER = 0.001;

    /**
     * Fails for what has no meaning.
     *
     * @throws enlightenment.math.InvalidValueException if there are no frames, framesPerSecond is not positive and finite, or shutter or
     *     instants are out of range
     * @throws NullPointerException if tracks or one of them is missing; the message says which
     */
    public Animation {
        Check.that(frames >= 1, "frames", "must be at least 1, not " + frames);
        Check.positive("framesPerSecond", framesPerSecond);
        Check.that(
                shutter == 0 || shutter >= LEAST_SHUTTER && shutter <= 1,
                "shutter",
                "must be 0 or in " + LEAST_SHUTTER + "..1, not " + shutter);
        Check.that(
                instants >= 1 && instants <= MOST_INSTANTS,
                "instants",
                "must be in 1.." + MOST_INSTANTS + ", not " + instants);
        // A scene file says no -0, and records with it would not be equal to what is read of it.
        shutter = shutter == 0 ? 0 : shutter;
        tracks = Present.list("tracks", "track", tracks);
    }

    /** Pictures of moments. */
    public Animation(int frames, double framesPerSecond, List<Track> tracks) {
        this(frames, framesPerSecond, tracks, 0, USUAL_INSTANTS);
    }

    /** Whether pictures show what moves while the shutter is open. */
    public boolean isBlurred() {
        return shutter > 0 && !tracks.isEmpty();
    }

    /** How a number goes from one key to the next. */
    public enum Easing {
        /** Always at the same speed. */
        LINEAR,

        /** Slowly at first and in the end: by s²(3 − 2s), where s goes from 0 to 1. */
        SMOOTH
    }

    /**
     * One changing number.
     *
     * @param target a JSON pointer to a number of the scene file
     * @param keys exact values at some frames, at least one, counted from 0, none of them null; constant before the first and after the
     *     last
     * @param easing how it goes from one to the next
     */
    public record Track(String target, NavigableMap<Integer, BigDecimal> keys, Easing easing) {
        /**
         * Fails for what has no meaning.
         *
         * @throws enlightenment.math.InvalidValueException if there are no keys, or one is of a frame before the first
         * @throws NullPointerException if target, a value or easing is missing; the message says which
         */
        public Track {
            Objects.requireNonNull(target, "target");
            Objects.requireNonNull(easing, "easing");
            Objects.requireNonNull(keys, "keys");
            Check.that(!keys.isEmpty(), "keys", "must hold at least one frame");
            keys.forEach((frame, value) -> {
                Check.that(frame >= 0, "keys/" + frame, "must be the number of a frame, at least 0");
                Objects.requireNonNull(value, () -> "the value at frame " + frame);
            });
            keys = Collections.unmodifiableNavigableMap(new TreeMap<>(keys));
        }

        /** At the same speed from key to key. */
        public Track(String target, NavigableMap<Integer, BigDecimal> keys) {
            this(target, keys, Easing.LINEAR);
        }
    }
}
