package enlightenment.bench;

import enlightenment.color.DisplayCurve;
import enlightenment.film.SplatBatch;
import enlightenment.film.SplatFilm;
import enlightenment.film.SplatScale;
import enlightenment.film.SplatSums;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** 100,000 splats that fall anywhere: into a batch, and from there into the film. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class SplatBenchmark {
    private static final int SPLATS = 100_000;

    /** Columns of the picture; half as many rows. */
    @Param({"800", "4000"})
    public int width;

    private final double[] places = new double[2 * SPLATS];
    private SplatBatch batch;
    private SplatFilm film;
    private SplatSums sums;
    private byte[] bytes;
    private int pixels;
    private int unit;

    @Setup
    public void setUp() {
        int height = width / 2;
        pixels = width * height;
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < SPLATS; i++) {
            places[2 * i] = width * random.nextDouble();
            places[2 * i + 1] = height * random.nextDouble();
        }
        SplatScale scale = SplatScale.of(0.5, 1L << 40, pixels);
        batch = new SplatBatch(0, 0, width, height, scale);
        film = new SplatFilm(0, 0, width, height, pixels, scale, DisplayCurve.SRGB);
        sums = batch();
        bytes = sums.toBytes();
    }

    @Benchmark
    public SplatSums batch() {
        batch.begin(SPLATS);
        for (int i = 0; i < SPLATS; i++) {
            batch.add(places[2 * i], places[2 * i + 1], 0.5, 0.25, 0.125);
        }
        return batch.sums();
    }

    @Benchmark
    public byte[] toBytes() {
        return sums.toBytes();
    }

    @Benchmark
    public SplatSums ofBytes() {
        return SplatSums.of(bytes, pixels);
    }

    @Benchmark
    public boolean film() {
        return film.add(unit++, sums);
    }
}
