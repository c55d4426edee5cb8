package enlightenment.spark;

import enlightenment.net.EngineJob;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.apache.spark.SimpleFutureAction;
import org.apache.spark.SparkConf;
import org.apache.spark.SparkException;
import org.apache.spark.api.java.JavaRDD;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import scala.collection.immutable.Seq;
import scala.jdk.javaapi.CollectionConverters;
import scala.runtime.AbstractFunction0;
import scala.runtime.AbstractFunction2;
import scala.runtime.BoxedUnit;

/**
 * Renders on an Apache Spark cluster: the same picture as {@link enlightenment.render.Renderer}, bit for bit, whichever
 * executors are lost meanwhile. The first units are cut short by the clock and tell how fast tiles are made; the others are
 * cut to {@link Units#SECONDS}.
 */
public final class SparkRender {
    private static final long TRIAL_NANOS = 2_000_000_000L;
    private static final long TICK_MILLIS = 200;

    private final JavaSparkContext spark;
    private final EngineJob job;
    private final RenderProgress progress;
    private final BooleanSupplier cancelled;
    private final Consumer<String> log;

    /** How long tiles took, of which the first of each unit are left out where others are: the compiler was at work. */
    private double seconds;

    private long timed;

    /** How long all tiles that arrived took. */
    private long busyNanos;

    private SparkRender(
            JavaSparkContext spark,
            EngineJob job,
            RenderProgress progress,
            BooleanSupplier cancelled,
            Consumer<String> log) {
        this.spark = spark;
        this.job = job;
        this.progress = progress;
        this.cancelled = cancelled;
        this.log = log;
    }

    /** Settings that Spark needs in order not to wait minutes for a frozen executor; what is set already stays. */
    public static SparkConf configure(SparkConf conf) {
        conf.setIfMissing("spark.app.name", "enlightenment");
        conf.setIfMissing("spark.speculation", "true");
        conf.setIfMissing("spark.speculation.quantile", "0.5");
        conf.setIfMissing("spark.speculation.multiplier", "1.5");
        conf.setIfMissing("spark.network.timeout", "60s");
        // Machines that are taken away again and again are no fault of the task.
        conf.setIfMissing("spark.task.maxFailures", "16");
        // Results are put into the picture as they arrive: all of them may well be more than 1 GB.
        conf.setIfMissing("spark.driver.maxResultSize", "0");
        return conf;
    }

    /**
     * Renders what is missing of a job.
     *
     * @param cancelled asked several times a second; once true, the picture stays incomplete
     * @param log hears of what a person may want to know
     * @throws IOException if Spark gives up: the same task failed too often, or the cluster is gone
     */
    public static RenderResult render(
            JavaSparkContext spark,
            EngineJob job,
            RenderProgress progress,
            BooleanSupplier cancelled,
            Consumer<String> log)
            throws IOException {
        new SparkRender(spark, job, progress, cancelled, log).run();
        return job.result();
    }

    private void run() throws IOException {
        int[] missing = job.missing();
        if (missing.length == 0) {
            return;
        }
        Broadcast<SharedRender> shared = spark.broadcast(new SharedRender(job.contents()));
        try {
            work(Units.deal(missing, spark.defaultParallelism()), new UnitTask(shared, TRIAL_NANOS));
            missing = job.missing();
            if (missing.length > 0 && !cancelled.getAsBoolean()) {
                long bytes = Arrays.stream(missing).mapToLong(job::longest).sum();
                int units = Units.number(seconds / timed * missing.length, spark.defaultParallelism(), bytes);
                work(Units.deal(missing, units), new UnitTask(shared, Long.MAX_VALUE));
            }
        } finally {
            shared.destroy();
        }
    }

    /** Has these units done, one task each, and keeps results as they arrive. */
    private void work(List<int[]> units, UnitTask task) throws IOException {
        BlockingQueue<byte[]> results = new LinkedBlockingQueue<>();
        long start = System.nanoTime();
        long before = busyNanos;
        SimpleFutureAction<Boolean> action = submit(units, task, results);
        while (!action.isCompleted()) {
            keep(results, TICK_MILLIS);
            if (cancelled.getAsBoolean()) {
                action.cancel();
                break;
            }
        }
        keep(results, 0);
        if (!cancelled.getAsBoolean()) {
            outcome(action);
            log.accept(String.format(
                    Locale.ROOT,
                    "%d tasks in %.1f s; their tiles took %.1f s of the %d cores",
                    units.size(),
                    (System.nanoTime() - start) / 1e9,
                    (busyNanos - before) / 1e9,
                    spark.defaultParallelism()));
        }
    }

    private SimpleFutureAction<Boolean> submit(List<int[]> units, UnitTask task, BlockingQueue<byte[]> results) {
        JavaRDD<int[]> rdd = spark.parallelize(units, units.size());
        Seq<Object> all = CollectionConverters.asScala(IntStream.range(0, units.size())
                        .<Object>mapToObj(i -> i)
                        .toList())
                .toSeq();
        return spark.sc()
                .submitJob(
                        rdd.rdd(),
                        task,
                        all,
                        new AbstractFunction2<Object, byte[], BoxedUnit>() {
                            @Override
                            public BoxedUnit apply(Object unit, byte[] result) {
                                // Called in Spark's scheduler, which must not wait for a disk.
                                results.add(result);
                                return BoxedUnit.UNIT;
                            }
                        },
                        new AbstractFunction0<Boolean>() {
                            @Override
                            public Boolean apply() {
                                return Boolean.TRUE;
                            }
                        });
    }

    private void keep(BlockingQueue<byte[]> results, long millis) throws IOException {
        try {
            byte[] next = results.poll(millis, TimeUnit.MILLISECONDS);
            for (; next != null; next = results.poll()) {
                UnitResult result = UnitResult.read(next);
                result.tiles().forEach(tile -> job.put(tile.tile(), tile.bytes(), result.machine()));
                measure(result.tiles());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        }
        job.tick();
        job.show(progress);
    }

    private void measure(List<UnitResult.Tile> tiles) {
        busyNanos += tiles.stream().mapToLong(UnitResult.Tile::nanos).sum();
        tiles.stream().skip(tiles.size() / 2).forEach(tile -> {
            seconds += tile.nanos() / 1e9;
            timed++;
        });
    }

    private static void outcome(SimpleFutureAction<Boolean> action) throws IOException {
        try {
            action.get();
        } catch (SparkException e) {
            throw new IOException("Spark gave up: " + e.getMessage(), e);
        }
    }
}
