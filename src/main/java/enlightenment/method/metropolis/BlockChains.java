package enlightenment.method.metropolis;

import enlightenment.method.Block;
import enlightenment.sampling.ChainSampler;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sobol;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Renders a quarter of the samples of a block: two groups of independent paths, and Markov chains that start from some of them. One per
 * thread.
 *
 * <p>See docs/notes/metropolis.md for why this is unbiased, however long chains are.
 */
final class BlockChains {
    private static final long PURPOSE = 0x6d6574726f706f6cL;
    private static final long FILM = 1;
    private static final long CHOICE = 2;
    private static final int QUARTERS = 4;

    /** The number of groups in a quarter. */
    private static final int GROUPS = 2;

    /** The assumed worth of a chain's step, in independent paths of the same brightness. */
    private static final double WORTH_OF_STEP = 0.2;

    /** The largest number of independent paths kept at a time. */
    private static final int MOST_STARTS = 1 << 16;

    private final Paths paths;
    private final ChainSampler sampler;
    private final RayCounters counters;
    private final double largeShare;
    private final int mutationsPerChain;
    private final Starts[] starts = {new Starts(), new Starts()};

    /** Sums over independent paths, and over steps of chains: red, green and blue of each pixel. */
    private double[] ofPaths = new double[0];

    private double[] ofSteps = new double[0];
    private double[] light = new double[0];

    /** Independent paths are weighted by 1/(1 + this times brightness), chains by the rest. */
    private double fade;

    /** The colour of the chain's current state. */
    private final double[] color = new double[3];

    private double brightness;
    private int pixel;

    /** The expected number of steps that the chain has stayed in the current state. */
    private double stay;

    private int independent;
    private long taken;

    private final boolean isRecorded;
    private final List<ChainStatistics> statistics = new ArrayList<>();
    private Block block;
    private long accepted;
    private long large;
    private long largeAccepted;

    /**
     * @param isRecorded whether {@link #statistics} are collected
     */
    BlockChains(Paths paths, double largeShare, int mutationsPerChain, RayCounters counters, boolean isRecorded) {
        this.isRecorded = isRecorded;
        this.paths = paths;
        this.largeShare = largeShare;
        this.mutationsPerChain = mutationsPerChain;
        this.counters = counters;
        sampler = new ChainSampler(largeShare);
    }

    /** The number of paths in the last quarter. */
    long taken() {
        return taken;
    }

    /** The number of these paths whose value was not finite. */
    long lost() {
        return paths.lost();
    }

    /** The radiance of the last quarter: component c of one of the block's pixels. */
    double light(int index, int c) {
        return light[3 * index + c];
    }

    /** Renders a quarter. */
    void render(Block next, int quarter, Spending spending, long seed) {
        block = next;
        statistics.clear();
        int numbers = 3 * block.pixels();
        if (light.length < numbers) {
            light = new double[numbers];
            ofPaths = new double[numbers];
            ofSteps = new double[numbers];
        }
        Arrays.fill(light, 0);
        taken = 0;
        paths.begin(block);
        long own = Hash.of(Hash.of(seed, PURPOSE), block.x(), block.y());
        double share = (double) block.pixels() / (QUARTERS * GROUPS);
        int rounds = (int) Math.ceil(share * spending.independent() / MOST_STARTS);
        int starting = (int) Math.max(Math.rint(share * spending.independent() / rounds), 1);
        long steps = Math.round(share * spending.mutations() / rounds);
        double scale = (double) block.pixels() / (GROUPS * rounds);
        for (int round = 0; round < rounds; round++) {
            long ofRound = Hash.of(own, quarter, round);
            for (int g = 0; g < GROUPS; g++) {
                begin(starts[g], Hash.of(ofRound, g), starting);
            }
            for (int g = 0; g < GROUPS; g++) {
                group(g, GROUPS * quarter + g, Hash.of(ofRound, g), steps);
                add(starts[g].mean() * scale, scale, numbers);
            }
        }
    }

    /** Traces independent paths, stratified over the block. */
    private void begin(Starts group, long seed, int count) {
        group.begin(count);
        for (int i = 0; i < count; i++) {
            start(seed, i, 0);
            group.add(paths.follow(sampler), paths);
        }
        taken += count;
    }

    private void start(long seed, int path, int copy) {
        sampler.begin(seed, path, copy);
        long film = Hash.of(seed, FILM);
        sampler.at(Sobol.x(path, film), Sobol.y(path, film));
    }

    /** The weights of a quarter's groups are computed from the other group, so that they are independent of what they weigh. */
    private void group(int g, int number, long seed, long steps) {
        Starts own = starts[g];
        int chains = (int) Math.max(Math.round((double) steps / mutationsPerChain), 1);
        long length = steps / chains;
        double expected = own.count() + largeShare * chains * length;
        fade = length == 0 ? 0 : WORTH_OF_STEP * chains * length / (expected * starts[1 - g].mean());
        Arrays.fill(ofPaths, 0);
        Arrays.fill(ofSteps, 0);
        independent = own.count();
        for (int i = 0; i < own.count(); i++) {
            double share = shareOfPaths(own.brightness(i));
            int k = 3 * own.pixel(i);
            for (int c = 0; c < 3; c++) {
                ofPaths[k + c] += share * own.color(i, c);
            }
        }
        follow(own, number, seed, chains, length);
        for (int k = 0; k < ofSteps.length; k++) {
            ofSteps[k] /= (double) chains * Math.max(length, 1);
        }
    }

    private void follow(Starts own, int number, long seed, int chains, long length) {
        boolean isDark = !(own.mean() > 0);
        double offset = Hash.unit(Hash.of(seed, CHOICE));
        for (int chain = 0; chain < chains; chain++) {
            int path = own.at((chain + offset) / chains);
            start(seed, path, chain + 1);
            if (isDark) {
                searchOn(length);
                continue;
            }
            own.color(path, color);
            brightness = own.brightness(path);
            pixel = own.pixel(path);
            int from = pixel;
            run(length);
            if (isRecorded) {
                record(number, from, own.brightness(path), own.mean(), length);
            }
        }
        if (!isDark) {
            counters.clusters += chains;
            counters.proposals += chains * length;
        }
    }

    private void record(int group, int from, double start, double mean, long length) {
        statistics.add(new ChainStatistics(
                block.x(),
                block.y(),
                group,
                block.x() + from % block.width(),
                block.y() + from / block.width(),
                block.x() + pixel % block.width(),
                block.y() + pixel / block.width(),
                start,
                mean,
                length,
                accepted,
                large,
                largeAccepted));
    }

    /** The statistics of the chains of the last quarter. */
    List<ChainStatistics> statistics() {
        return List.copyOf(statistics);
    }

    private double shareOfPaths(double bright) {
        return bright > 0 ? 1 / (1 + fade * bright) : 1;
    }

    /** The share of a path's light that chains estimate, divided by the path's brightness. */
    private double shareOfSteps(double bright) {
        return fade < Double.POSITIVE_INFINITY ? fade / (1 + fade * bright) : 1 / bright;
    }

    private void run(long length) {
        stay = 0;
        accepted = 0;
        large = 0;
        largeAccepted = 0;
        for (long step = 0; step < length; step++) {
            sampler.propose();
            double next = paths.follow(sampler);
            if (sampler.isLarge()) {
                addIndependent(next);
                large++;
            }
            double chance = next < brightness ? next / brightness : 1;
            stay += 1 - chance;
            if (sampler.decision() < chance) {
                leave();
                sampler.accept();
                accepted++;
                largeAccepted += sampler.isLarge() ? 1 : 0;
                System.arraycopy(paths.color, 0, color, 0, 3);
                pixel = paths.pixel;
                brightness = next;
                stay = chance;
            } else {
                sampler.reject();
                if (chance > 0) {
                    splat(paths.pixel, paths.color, chance * shareOfSteps(next));
                }
            }
        }
        leave();
        counters.accepted += accepted;
        taken += length;
    }

    /** Adds the contribution of the state that the chain leaves. */
    private void leave() {
        splat(pixel, color, stay * shareOfSteps(brightness));
    }

    private void splat(int where, double[] rgb, double weight) {
        int k = 3 * where;
        ofSteps[k] += weight * rgb[0];
        ofSteps[k + 1] += weight * rgb[1];
        ofSteps[k + 2] += weight * rgb[2];
    }

    private void addIndependent(double bright) {
        independent++;
        double share = shareOfPaths(bright);
        int k = 3 * paths.pixel;
        for (int c = 0; c < 3; c++) {
            ofPaths[k + c] += share * paths.color[c];
        }
    }

    /** Where no path found any light, chains have none to add; but their large steps are independent paths. */
    private void searchOn(long length) {
        for (long step = 0; step < length; step++) {
            sampler.propose();
            if (sampler.isLarge()) {
                addIndependent(paths.follow(sampler));
                taken++;
            }
            sampler.reject();
        }
    }

    private void add(double perStep, double scale, int numbers) {
        double perPath = scale / independent;
        for (int k = 0; k < numbers; k++) {
            light[k] += perPath * ofPaths[k] + perStep * ofSteps[k];
        }
    }
}
