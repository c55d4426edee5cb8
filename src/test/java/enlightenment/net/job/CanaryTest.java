package enlightenment.net.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.engine.DividedRender;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class CanaryTest {
    /** With too few samples one method stands in for another. */
    @Test
    void everyMethodRendersPartOfItItself() {
        List<DividedRender> renders = Canary.renders();
        Set<Method> methods = new HashSet<>();
        boolean followsLight = false;
        for (DividedRender render : renders) {
            methods.add(render.plan().method());
            followsLight |= render.plan().lightPaths() > 0;
        }
        assertEquals(new HashSet<>(BuiltInMethod.ALL), methods);
        assertEquals(9, renders.size(), "three methods of classic shading, and six of physical");
        assertTrue(followsLight);
    }

    @Test
    void itIsTheSameEachTime() {
        assertEquals(Canary.hash(), Canary.hash());
    }
}
