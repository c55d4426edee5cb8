package enlightenment.spark;

import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.util.function.IntFunction;
import org.apache.spark.TaskContext;
import org.apache.spark.broadcast.Broadcast;
import scala.collection.Iterator;
import scala.runtime.AbstractFunction1;

/** What an executor does with a unit: makes its tiles one after the other, those that there is time for. */
final class UnitTask extends AbstractFunction1<Iterator<int[]>, byte[]> implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Broadcast<SharedRender> shared;
    private final long nanos;

    /** With a limit to the time, after which no tile is begun; at least one is made. */
    UnitTask(Broadcast<SharedRender> shared, long nanos) {
        this.shared = shared;
        this.nanos = nanos;
    }

    @Override
    public byte[] apply(Iterator<int[]> units) {
        try {
            UnitResult.Writer out = new UnitResult.Writer();
            IntFunction<byte[]> maker = shared.value().maker();
            long start = System.nanoTime();
            while (units.hasNext()) {
                make(units.next(), maker, start, out);
            }
            return out.finish();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void make(int[] unit, IntFunction<byte[]> maker, long start, UnitResult.Writer out) throws IOException {
        long last = System.nanoTime();
        for (int tile : unit) {
            if (last - start > nanos) {
                return;
            }
            // Somebody else was faster, or the render was stopped.
            TaskContext.get().killTaskIfInterrupted();
            byte[] bytes = maker.apply(tile);
            long now = System.nanoTime();
            out.add(tile, bytes, now - last);
            last = now;
        }
    }
}
