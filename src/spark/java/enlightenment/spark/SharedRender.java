package enlightenment.spark;

import enlightenment.net.EngineJob;
import enlightenment.render.TiledRender;
import java.io.IOException;
import java.io.Serializable;
import java.util.List;

/** A render as Spark broadcasts it: contents by their hashes; compiled once in each executor, when first wanted. */
final class SharedRender implements Serializable {
    private static final long serialVersionUID = 1L;

    private final byte[][] contents;
    private transient TiledRender render;

    SharedRender(List<byte[]> contents) {
        this.contents = contents.toArray(new byte[0][]);
    }

    /** The render, for all tasks of this process. */
    synchronized TiledRender render() throws IOException {
        if (render == null) {
            render = EngineJob.render(List.of(contents));
        }
        return render;
    }
}
