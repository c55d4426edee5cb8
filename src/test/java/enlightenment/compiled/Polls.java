package enlightenment.compiled;

import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** How often work asks whether it is to end. */
final class Polls {
    /** Lets work come to its end. */
    static final int NEVER = Integer.MAX_VALUE;

    private Polls() {}

    /**
     * How often it asks.
     *
     * @param patience which of its questions is answered by yes first, upon which it has to end by a {@link CancellationException}; or
     *     {@link #NEVER}
     */
    static int of(int patience, Consumer<BooleanSupplier> work) {
        int[] asked = new int[1];
        BooleanSupplier ends = () -> ++asked[0] >= patience;
        if (patience == NEVER) {
            work.accept(ends);
        } else {
            assertThrows(CancellationException.class, () -> work.accept(ends));
        }
        return asked[0];
    }

    /** How often compiling asks. */
    static int ofCompiling(int patience, Scene scene) {
        return of(patience, ends -> SceneCompiler.compile(scene, RenderSettings.of(scene), new SceneImages(), ends));
    }
}
