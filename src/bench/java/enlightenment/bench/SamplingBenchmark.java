package enlightenment.bench;

import enlightenment.sampling.Distribution;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Proposal;
import enlightenment.sampling.Sobol;
import enlightenment.sampling.Warp;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** What a sample point costs: random numbers, evenly spread points, points on a disk, proposals of the ray clusters. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class SamplingBenchmark {
    private static final int COUNT = 4096;

    /** A proposal of each family; the other benchmarks need not run once for each. */
    @State(Scope.Thread)
    public static class Family {
        @Param({"normal", "zeta", "linear"})
        public String family;

        private Proposal proposal;

        @Setup
        public void setUp() {
            proposal = new Proposal(Distribution.of(family));
            proposal.set(0.25, 0.5, -1, 1);
        }
    }

    @Benchmark
    @OperationsPerInvocation(COUNT)
    public double hash() {
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            sum += Hash.unit(Hash.of(7, i));
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(COUNT)
    public double sobol() {
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            sum += Sobol.x(i, 7) + Sobol.y(i, 7);
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(COUNT)
    public double disk() {
        double[] out = new double[3];
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            Warp.toDisk((i + 0.5) / COUNT, (i * 37 % COUNT + 0.5) / COUNT, out);
            sum += out[0] + out[1];
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(COUNT)
    public double proposal(Family family) {
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            sum += family.proposal.sample((i + 0.5) / COUNT);
        }
        return sum;
    }
}
