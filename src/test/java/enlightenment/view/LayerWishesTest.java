package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.render.RenderResult;
import java.util.EnumSet;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class LayerWishesTest {
    private final AtomicLong clock = new AtomicLong(-5);
    private final LayerWishes wishes = new LayerWishes(clock::get);

    @Test
    void aWishEndsUnlessItIsRenewed() {
        wishes.add(Layer.NORMAL);
        wishes.add(Layer.DEPTH);
        clock.addAndGet(LayerWishes.WISH_NANOS);
        wishes.add(Layer.DEPTH);
        assertEquals(EnumSet.of(RenderResult.Auxiliary.NORMAL, RenderResult.Auxiliary.DEPTH), wishes.current());
        clock.addAndGet(1);
        assertEquals(Set.of(RenderResult.Auxiliary.DEPTH), wishes.current());
        wishes.clear();
        assertEquals(Set.of(), wishes.current());
    }

    @Test
    void objectsAndMaterialsAreMadeOfTheSameNumbers() {
        wishes.add(Layer.OBJECT);
        wishes.add(Layer.MATERIAL);
        wishes.add(Layer.PICTURE);
        wishes.add(Layer.ERROR);
        assertEquals(Set.of(RenderResult.Auxiliary.OBJECT), wishes.current());
    }
}
