package enlightenment.sampling;

import enlightenment.numeric.Exponential;
import java.util.Arrays;

/**
 * The states of a Markov chain in primary sample space: all the numbers that a path may ask for, changed from step to step
 * (C. Kelemen, L. Szirmay-Kalos, G. Antal and F. Csonka, "A simple and robust mutation strategy for the Metropolis light transport
 * algorithm", Eurographics 2002). A large step draws all of them anew; a small step moves each by s₂·exp(−ξ ln(s₂/s₁)) to one side
 * or the other, where 0 and 1 are the same place. The place on the film goes four times as far, and in half of the small steps is all
 * that moves. All are symmetric: the chance to go is the chance to come back.
 *
 * <p>Numbers are multiples of 2⁻⁵³ and are kept as whole ones, so that moves are exact and uniform numbers stay uniform. A
 * number is a pure function of (seed, chain, address) and of which steps were accepted. Whether it was asked for before makes no
 * difference: what is kept is only a memory of what was worked out.
 */
public final class ChainSampler implements Sampler {
    /** The ratio of the shortest to the longest small step, and the longest: Kelemen's. */
    private static final double SHORTEST = Math.scalb(1.0, -10);

    private static final double LONGEST = Math.scalb(1.0, -6);
    private static final double LOG_OF_RATIO = StrictMath.log(LONGEST / SHORTEST);

    /** Binary logarithm of the ratio of the length of small steps on the film to that of others. */
    private static final int FURTHER_ON_FILM = 2;

    /** The bit of a step's hash that decides whether a small step changes the film position alone. */
    private static final long ONLY_ON_FILM = 1;

    private static final int BITS = 53;
    private static final long MASK = (1L << BITS) - 1;

    /** Addresses of the film position and of numbers at bounces; those of light points and of flights are hashes. */
    private static final long FILM_X = 0;

    private static final long FILM_Y = 1;
    private static final long FIRST_PURPOSE = 2;
    private static final int PER_PURPOSE = 3;
    private static final int PER_BOUNCE = PER_PURPOSE * Purpose.FLIGHT.ordinal();

    /** Addresses of numbers that belong to no path: for the kind of a step, and for its acceptance. */
    private static final long SIZE_OF_STEP = -1;

    private static final long DECISION = -2;

    private static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;
    private static final int FEWEST_SLOTS = 256;

    private final double largeShare;

    /** The seed of the numbers of step 0, and that of all later steps. */
    private long start;

    private long chain;
    private int step;
    private long stepHash;
    private boolean proposing;
    private boolean large;

    /** The number of the last accepted large step, and the hashes of the accepted small steps since, in order. */
    private long lastLarge;

    private long[] small = new long[64];
    private int smallCount;

    /** Counts accepted large steps: numbers stored before the last one are invalid. */
    private int epoch;

    /** By slot of an open-addressing table: address, epoch, number, and how many of the small steps are applied to it. */
    private long[] addresses = new long[FEWEST_SLOTS];

    private int[] epochs = new int[FEWEST_SLOTS];
    private long[] numbers = new long[FEWEST_SLOTS];
    private int[] made = new int[FEWEST_SLOTS];

    /** The number after the small step with this hash, to be stored if the step is accepted. */
    private long[] proposed = new long[FEWEST_SLOTS];

    private long[] proposedBy = new long[FEWEST_SLOTS];
    private int used;

    private long lightPlace;

    /**
     * Makes a sampler; {@link #begin} starts a chain.
     *
     * @param largeShare the probability of large steps, above 0 and at most 1
     */
    public ChainSampler(double largeShare) {
        if (!(largeShare > 0 && largeShare <= 1)) {
            throw new IllegalArgumentException("share of large steps: " + largeShare);
        }
        this.largeShare = largeShare;
    }

    /** Begins a chain at its step 0, whose numbers are those of a large step. */
    public void begin(long seed, long number) {
        begin(seed, number, 0);
    }

    /**
     * Begins one of several chains that have the same step 0 and are independent from there on.
     *
     * @param copy which of the chains
     */
    public void begin(long seed, long number, int copy) {
        start = Hash.of(seed, number);
        chain = Hash.of(start, copy);
        Arrays.fill(epochs, 0);
        epoch = 0;
        step = 0;
        goOnFrom(start);
        proposing = false;
    }

    /** Sets the film position of step 0, for callers that stratify it. Must precede any other step. */
    public void at(double x, double y) {
        put(FILM_X, (long) Math.scalb(x, BITS));
        put(FILM_Y, (long) Math.scalb(y, BITS));
    }

    private void put(long address, long number) {
        current(address);
        numbers[slot(address)] = number & MASK;
    }

    private void goOnFrom(long largeStep) {
        lastLarge = largeStep;
        smallCount = 0;
        used = 0;
        epoch++;
    }

    /** Proposes the next step: numbers are those of the proposed state until {@link #accept} or {@link #reject}. */
    public void propose() {
        step++;
        stepHash = Hash.of(chain, step);
        proposing = true;
        large = Hash.unit(hash(stepHash, SIZE_OF_STEP)) < largeShare;
    }

    /** Whether the last proposal is a large step. */
    public boolean isLarge() {
        return large;
    }

    /** A number in [0, 1) for the acceptance of the proposal; no path uses it. */
    public double decision() {
        return Hash.unit(hash(stepHash, DECISION));
    }

    /** Accepts the proposal as the state of the chain. */
    public void accept() {
        proposing = false;
        if (large) {
            goOnFrom(stepHash);
            return;
        }
        if (smallCount == small.length) {
            small = Arrays.copyOf(small, 2 * smallCount);
        }
        small[smallCount++] = stepHash;
    }

    /** Rejects the proposal: numbers are those of the state before it. */
    public void reject() {
        proposing = false;
    }

    @Override
    public double filmX() {
        return number(FILM_X);
    }

    @Override
    public double filmY() {
        return number(FILM_Y);
    }

    @Override
    public double unit(int bounce, Purpose purpose) {
        return number(place(bounce, purpose));
    }

    @Override
    public void pair(int bounce, Purpose purpose, double[] out) {
        long place = place(bounce, purpose);
        out[0] = number(place + 1);
        out[1] = number(place + 2);
    }

    private static long place(int bounce, Purpose purpose) {
        // Purposes that few scenes use have addresses of their own, so that they do not shift other numbers.
        return purpose.ordinal() < Purpose.FLIGHT.ordinal()
                ? FIRST_PURPOSE + (long) PER_BOUNCE * bounce + PER_PURPOSE * purpose.ordinal()
                : Hash.of(-purpose.ordinal(), bounce);
    }

    @Override
    public void lightPoints(int light, int bounce, int count) {
        lightPlace = Hash.of(light, bounce);
    }

    @Override
    public double lightX(int k) {
        return number(lightPlace + 2L * k);
    }

    @Override
    public double lightY(int k) {
        return number(lightPlace + 2L * k + 1);
    }

    private double number(long address) {
        if (proposing && large) {
            return Math.scalb((double) drawn(address, stepHash), -BITS);
        }
        int slot = current(address);
        long n = numbers[slot];
        if (proposing) {
            if (proposedBy[slot] != stepHash) {
                proposed[slot] = moved(n, address, stepHash);
                proposedBy[slot] = stepHash;
            }
            n = proposed[slot];
        }
        return Math.scalb((double) n, -BITS);
    }

    /** Applies accepted steps to the chain's number at an address, without the proposal; returns its slot. */
    private int current(long address) {
        if (2 * used >= addresses.length) {
            grow();
        }
        int slot = slot(address);
        if (epochs[slot] != epoch) {
            used++;
            epochs[slot] = epoch;
            addresses[slot] = address;
            numbers[slot] = drawn(address, lastLarge);
            made[slot] = 0;
            // A step's hash is practically never 0.
            proposedBy[slot] = 0;
        }
        if (made[slot] < smallCount) {
            catchUp(slot, address);
        }
        return slot;
    }

    private void catchUp(int slot, long address) {
        long n = numbers[slot];
        for (int k = made[slot]; k < smallCount; k++) {
            n = small[k] == proposedBy[slot] ? proposed[slot] : moved(n, address, small[k]);
        }
        made[slot] = smallCount;
        numbers[slot] = n;
    }

    private static long hash(long stepHash, long address) {
        return Hash.mix(stepHash + address * GOLDEN_GAMMA);
    }

    private static long drawn(long address, long largeStep) {
        return hash(largeStep, address) >>> Long.SIZE - BITS;
    }

    private static long moved(long n, long address, long smallStep) {
        boolean isOnFilm = address == FILM_X || address == FILM_Y;
        if (!isOnFilm && (smallStep & ONLY_ON_FILM) != 0) {
            return n;
        }
        long h = hash(smallStep, address);
        double distance = LONGEST * Exponential.exp(-LOG_OF_RATIO * Hash.unit(h));
        long d = (long) Math.scalb(distance, BITS);
        if (isOnFilm) {
            d <<= FURTHER_ON_FILM;
        }
        // The sign bit is not among the bits of the distance.
        return (n + ((h & 1) == 0 ? d : -d)) & MASK;
    }

    /** The slot of an address, used or free: the first from its own on that has this address, or none of this epoch. */
    private int slot(long address) {
        int mask = addresses.length - 1;
        int slot = (int) address & mask;
        while (epochs[slot] == epoch && addresses[slot] != address) {
            slot = (slot + 1) & mask;
        }
        return slot;
    }

    private void grow() {
        long[] oldAddresses = addresses;
        int[] oldEpochs = epochs;
        long[] oldNumbers = numbers;
        int[] oldMade = made;
        int slots = 2 * oldAddresses.length;
        addresses = new long[slots];
        epochs = new int[slots];
        numbers = new long[slots];
        made = new int[slots];
        proposed = new long[slots];
        proposedBy = new long[slots];
        for (int k = 0; k < oldAddresses.length; k++) {
            if (oldEpochs[k] == epoch) {
                int slot = slot(oldAddresses[k]);
                addresses[slot] = oldAddresses[k];
                epochs[slot] = epoch;
                numbers[slot] = oldNumbers[k];
                made[slot] = oldMade[k];
            }
        }
    }
}
