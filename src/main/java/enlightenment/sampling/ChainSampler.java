package enlightenment.sampling;

import java.util.Arrays;

/**
 * The states of a Markov chain in primary sample space: all the numbers that a path may ask for, changed from step to step
 * (C. Kelemen, L. Szirmay-Kalos, G. Antal and F. Csonka, "A simple and robust mutation strategy for the Metropolis light transport
 * algorithm", Eurographics 2002). A large step draws all of them anew; a small step moves each by s₂·exp(−ξ ln(s₂/s₁)) to one side
 * or the other, where 0 and 1 are the same place. Both are symmetric: the chance to go is the chance to come back.
 *
 * <p>Numbers are multiples of 2⁻⁵³ and are kept as whole ones, so that moves are exact and uniform numbers stay uniform. A
 * number is a pure function of (seed, chain, address) and of which steps were accepted. Whether it was asked for before makes no
 * difference: what is kept is only a memory of what was worked out.
 */
public final class ChainSampler implements Sampler {
    /** The shortest small step over the longest one, and that one: Kelemen's. */
    private static final double SHORTEST = Math.scalb(1.0, -10);

    private static final double LONGEST = Math.scalb(1.0, -6);
    private static final double LOG_OF_RATIO = StrictMath.log(LONGEST / SHORTEST);

    private static final int BITS = 53;
    private static final long MASK = (1L << BITS) - 1;

    private static final long FILM = 0;
    private static final long FIRST_PURPOSE = 1;
    private static final long FIRST_LIGHT = FIRST_PURPOSE + Purpose.values().length;

    /** Instead of an address, for whether a step is large. */
    private static final long SIZE_OF_STEP = -1;

    private static final int FEWEST_SLOTS = 256;

    private final double largeShare;
    private long chainHash;
    private int step;
    private boolean proposing;
    private boolean large;

    /** The last large step that was accepted, and the small ones since, in order. */
    private int lastLarge;

    private int[] small = new int[64];
    private int smallCount;

    /** Grows with each accepted large step: numbers remembered from before it are worth nothing. */
    private int epoch;

    /** By slot, found by open addressing: address, epoch, number, and how many of the small steps it has made. */
    private long[] addresses = new long[FEWEST_SLOTS];

    private int[] epochs = new int[FEWEST_SLOTS];
    private long[] numbers = new long[FEWEST_SLOTS];
    private int[] made = new int[FEWEST_SLOTS];
    private int used;

    private long lightPlace;

    /**
     * A sampler to {@link #begin} a chain with.
     *
     * @param largeShare the share of large steps, above 0 and at most 1
     */
    public ChainSampler(double largeShare) {
        if (!(largeShare > 0 && largeShare <= 1)) {
            throw new IllegalArgumentException("share of large steps: " + largeShare);
        }
        this.largeShare = largeShare;
    }

    /** Begins a chain at its step 0, whose numbers are drawn as by a large step. */
    public void begin(long seed, long chain) {
        chainHash = Hash.of(seed, chain);
        Arrays.fill(epochs, 0);
        epoch = 0;
        step = 0;
        goOnFrom(0);
        proposing = false;
    }

    private void goOnFrom(int largeStep) {
        lastLarge = largeStep;
        smallCount = 0;
        used = 0;
        epoch++;
    }

    /** Proposes the next step: numbers are those of the proposed state until {@link #accept} or {@link #reject}. */
    public void propose() {
        step++;
        proposing = true;
        large = Hash.unit(Hash.of(chainHash, SIZE_OF_STEP, step)) < largeShare;
    }

    /** Whether the last step proposed is a large one. */
    public boolean isLarge() {
        return large;
    }

    /** Makes the proposed state that of the chain. */
    public void accept() {
        proposing = false;
        if (large) {
            goOnFrom(step);
            return;
        }
        if (smallCount == small.length) {
            small = Arrays.copyOf(small, 2 * smallCount);
        }
        small[smallCount++] = step;
    }

    /** Returns to the state before the step. */
    public void reject() {
        proposing = false;
    }

    @Override
    public double filmX() {
        return number(Hash.of(FILM, 0));
    }

    @Override
    public double filmY() {
        return number(Hash.of(FILM, 1));
    }

    @Override
    public double unit(int bounce, Purpose purpose) {
        return number(Hash.of(place(bounce, purpose), 0));
    }

    @Override
    public void pair(int bounce, Purpose purpose, double[] out) {
        long place = place(bounce, purpose);
        out[0] = number(Hash.of(place, 1));
        out[1] = number(Hash.of(place, 2));
    }

    private static long place(int bounce, Purpose purpose) {
        return Hash.of(FIRST_PURPOSE + purpose.ordinal(), bounce);
    }

    @Override
    public void lightPoints(int light, int bounce, int count) {
        lightPlace = Hash.of(FIRST_LIGHT + light, bounce);
    }

    @Override
    public double lightX(int k) {
        return number(Hash.of(lightPlace, 2L * k));
    }

    @Override
    public double lightY(int k) {
        return number(Hash.of(lightPlace, 2L * k + 1));
    }

    private double number(long address) {
        long n;
        if (proposing && large) {
            n = drawn(address, step);
        } else {
            n = current(address);
            n = proposing ? moved(n, address, step) : n;
        }
        return Math.scalb((double) n, -BITS);
    }

    /** The chain's own number, before what is proposed. */
    private long current(long address) {
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
        }
        long n = numbers[slot];
        for (int k = made[slot]; k < smallCount; k++) {
            n = moved(n, address, small[k]);
        }
        made[slot] = smallCount;
        numbers[slot] = n;
        return n;
    }

    private long drawn(long address, int largeStep) {
        return Hash.of(chainHash, address, largeStep) >>> Long.SIZE - BITS;
    }

    private long moved(long n, long address, int smallStep) {
        long h = Hash.of(chainHash, address, smallStep);
        double distance = LONGEST * Exponential.exp(-LOG_OF_RATIO * Hash.unit(h));
        long d = (long) Math.scalb(distance, BITS);
        // The bit of the sign is not among those of the distance.
        return (n + ((h & 1) == 0 ? d : -d)) & MASK;
    }

    /** Where an address is, or goes: the first slot from its own on that holds it, or nothing of this epoch. */
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
