package enlightenment.world.parts;

import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.light.SceneImages;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** How often work asks whether it is to end. */
public final class Polls {
    /** Lets work come to its end. */
    public static final int NEVER = Integer.MAX_VALUE;

    private Polls() {}

    /**
     * How often it asks.
     *
     * @param patience which of its questions is answered by yes first, upon which it has to end by a {@link CancellationException}; or
     *     {@link #NEVER}
     */
    public static int of(int patience, Consumer<BooleanSupplier> work) {
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
    public static int ofCompiling(int patience, Scene scene) {
        return of(patience, ends -> SceneCompiler.compile(scene, RenderSettings.of(scene), new SceneImages(), ends));
    }
}
