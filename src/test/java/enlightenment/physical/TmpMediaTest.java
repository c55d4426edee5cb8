package enlightenment.physical;

import enlightenment.scene.*;
import java.util.*;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class TmpMediaTest {
    static Stream<String> scenes() {
        Map<String, SceneBuilder> m = new TreeMap<>();
        MediaScenes.addTo(m);
        return m.keySet().stream().filter(n -> n.matches(System.getProperty("scenes", ".*")));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void same(String name) {
        Scene s = PartnerScenes.all().get(name);
        long t0 = System.nanoTime();
        BuiltInMethod m = BuiltInMethod.valueOf(System.getProperty("m", "RAYTRACE"));
        RenderSettings st = RenderSettings.of(s).withAntialias(8);
        try {
            NaivePartnerTest.compare(
                    s, m == BuiltInMethod.RAYTRACE ? st : st.withMethod(m), new NaiveTracer(s), 16, 200_000);
            System.err.println("OK " + name + " " + (System.nanoTime() - t0) / 1e9);
        } catch (AssertionError e) {
            System.err.println("BAD " + name + "\n" + e.getMessage());
            throw e;
        }
    }
}
