package enlightenment.net.job;

import enlightenment.engine.Rendered;
import enlightenment.render.RenderResult;
import java.util.List;
import java.util.Map;

/** Pictures of many machines as those of one. */
public final class Results {
    private Results() {}

    public static RenderResult of(Rendered rendered) {
        return new RenderResult(
                rendered.image(), rendered.report(), rendered.complete(), rendered.shownPixels(), Map.of(), List.of());
    }
}
