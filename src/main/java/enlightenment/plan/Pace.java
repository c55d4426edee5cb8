package enlightenment.plan;

import enlightenment.scene.RenderSettings;

/**
 * Turns a time into a number of samples, from trials whose durations it is given; it reads no clock. Trials go on until they get no faster,
 * because the just-in-time compiler needs a while; each has about the number of samples that the one before proposed, because the first
 * samples of a pixel may cost more than others.
 */
final class Pace {
    /** The share of a time budget that one trial may take, that they all take at least, and at most. */
    private static final double ONE_TRIAL_TIME = 0.06;

    static final double LEAST_TRIAL_TIME = 0.12;
    private static final double MOST_TRIAL_TIME = 0.4;

    /** At least this many trials, unless too much of the budget is gone; and at most this many, even if a clock stands still. */
    private static final int LEAST_TRIALS = 4;

    private static final int MOST_TRIALS = 10_000;

    private static final double LAST_CALL = 0.6;

    /**
     * Seconds after which the code is about as fast as it gets on a machine that does nothing else. Until then its speed was measured to
     * grow about with the square root of the time.
     */
    private static final double WARM = 2.5;

    /** Until this share of the time is gone a trial costs little beside what it tells, however long that is. */
    private static final double CHEAP = 0.08;

    /** A trial counts as faster only by this factor; after {@link #CALM} trials that were not faster no more are made. */
    private static final double FASTER = 1.04;

    private static final int CALM = 3;

    /** The share of the time that is left that is planned with. */
    private static final double PLANNED_TIME = 0.93;

    /** With time for this many times the wanted samples, at the last trials' speed, time is no limit. */
    private static final double PLENTY = 2;

    /** The duration in seconds that stands for one below the clock's resolution. */
    private static final double INSTANT = 1e-9;

    private final double seconds;
    private final double pixels;
    private final double trialPixels;
    private final double wanted;
    private double fastest;
    private double previous;

    /** Pixel samples per second. */
    private double speed;

    private int calm;
    private int trials;
    private double elapsed;

    /**
     * @param seconds the budget
     * @param pixels how many pixels the render has, in multiples of its passes
     * @param trialPixels how many a trial has
     * @param wanted the samples per pixel that are taken if there is time for them
     */
    Pace(double seconds, double pixels, double trialPixels, double wanted) {
        this.seconds = seconds;
        this.pixels = pixels;
        this.trialPixels = trialPixels;
        this.wanted = wanted;
    }

    /** From now on trials follow other rays, at another speed. */
    void otherRays() {
        previous = 0;
        fastest = 0;
        calm = 0;
    }

    /**
     * A trial is over.
     *
     * @param samples how many samples per pixel it took
     * @param took seconds for them
     * @param now seconds since the budget began
     */
    void tried(double samples, double took, double now) {
        double perSecond = samples * trialPixels / Math.max(took, INSTANT);
        calm = perSecond < fastest * FASTER ? calm + 1 : 0;
        // Of two trials the faster: other programs slow down one now and then, but nothing makes it too fast.
        speed = Math.max(perSecond, previous);
        previous = perSecond;
        fastest = Math.max(fastest, perSecond);
        elapsed = Math.max(now, INSTANT);
        trials++;
    }

    /** Whether another trial would tell something, and there is time for it. */
    boolean isWorthTrying() {
        if (trials < LEAST_TRIALS) {
            return elapsed < LAST_CALL * seconds;
        }
        return trials < MOST_TRIALS
                && elapsed < Math.max(Math.min(MOST_TRIAL_TIME * seconds, WARM), CHEAP * seconds)
                && (calm < CALM || elapsed < LEAST_TRIAL_TIME * seconds);
    }

    /** Whether there is so much time that no further trial can change what is taken. */
    boolean isPlenty() {
        return trials > 0 && affordable(elapsed) >= PLENTY * wanted;
    }

    /** The number of samples to try next, at least 1 and at most what is wanted. */
    double next() {
        double ofOneTrial = ONE_TRIAL_TIME * seconds * speed / trialPixels;
        double n = Math.min(planned(elapsed), ofOneTrial);
        // In this order what is no number becomes 1.
        return n > 1 ? Math.min(n, Math.min(wanted, RenderSettings.Budget.MAX_SAMPLES)) : 1;
    }

    /**
     * The number of samples per pixel for the rest of the time at the expected speed; at least 0.
     *
     * @param now seconds since the budget began
     */
    double planned(double now) {
        double planned = affordable(now) * warming();
        return planned > 0 ? planned : 0;
    }

    /** Samples per pixel for the rest of the time at the last trials' speed; negative if no time is left. */
    private double affordable(double now) {
        return PLANNED_TIME * (seconds - now) * speed / pixels;
    }

    /** The factor by which the render will be faster than the last trials, if they were still getting faster. */
    private double warming() {
        if (trials == 0 || calm >= CALM - 1) {
            return 1;
        }
        double middle = (elapsed + Math.min(seconds, WARM)) / 2;
        return Math.sqrt(Math.max(middle / elapsed, 1));
    }
}
