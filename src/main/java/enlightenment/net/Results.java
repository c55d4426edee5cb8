package enlightenment.net;

import enlightenment.engine.Rendered;
import enlightenment.render.RenderResult;
import java.util.List;
import java.util.Map;

/** Pictures of many machines as those of one. */
final class Results {
    private Results() {}

    static RenderResult of(Rendered rendered) {
        return new RenderResult(
                rendered.image(), rendered.report(), rendered.complete(), rendered.shownPixels(), Map.of(), List.of());
    }
}
