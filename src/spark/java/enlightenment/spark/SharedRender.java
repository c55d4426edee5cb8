package enlightenment.spark;

import enlightenment.net.EngineJob;
import java.io.IOException;
import java.io.Serializable;
import java.util.List;
import java.util.function.IntFunction;
import java.util.function.Supplier;

/** A render as Spark broadcasts it: contents by their hashes; compiled once in each executor, when first wanted. */
final class SharedRender implements Serializable {
    private static final long serialVersionUID = 1L;

    private final byte[][] contents;
    private transient Supplier<IntFunction<byte[]>> makers;

    SharedRender(List<byte[]> contents) {
        this.contents = contents.toArray(new byte[0][]);
    }

    /** What makes tiles, for one task; all tasks of this process share the compiled scene. */
    synchronized IntFunction<byte[]> maker() throws IOException {
        if (makers == null) {
            makers = EngineJob.makers(List.of(contents));
        }
        return makers.get();
    }
}
