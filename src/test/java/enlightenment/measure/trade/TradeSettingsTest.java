package enlightenment.measure.trade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.math.InvalidValueException;
import enlightenment.measure.analysis.SyntheticImages;
import enlightenment.measure.analysis.SyntheticRuns;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.Shading;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

class TradeSettingsTest {
    private static final TradeSettings USUAL =
            TradeSettings.of(SyntheticRuns.settings().base(), Shading.Model.CLASSIC, "a scene");

    @Test
    void theUsualSettingsCompareAllMethodsOfThisProgramThatCanRenderTheScene() {
        assertEquals(Method.words(BuiltInMethod.rendering(Shading.Model.CLASSIC)), USUAL.methods());
        TradeSettings physical = TradeSettings.of(USUAL.base(), Shading.Model.PHYSICAL, "a scene");
        assertEquals(Method.words(BuiltInMethod.rendering(Shading.Model.PHYSICAL)), physical.methods());
        assertTrue(USUAL.reference().isEmpty() && USUAL.sweeps().isEmpty());
    }

    @Test
    void eachWithMethodChangesOneValue() {
        Image reference = SyntheticImages.gradient(8, 8);
        List<Sweep> sweeps = List.of(Sweep.parse("antialias=1..2"));
        TradeSettings all = USUAL.withMethods(List.of("cluster"))
                .withBudgetSeconds(7)
                .withSeeds(5)
                .withSweeps(sweeps)
                .withReference(reference);
        assertEquals(
                new TradeSettings(
                        USUAL.shading(),
                        USUAL.base(),
                        List.of("cluster"),
                        7,
                        5,
                        sweeps,
                        Optional.of(reference),
                        USUAL.sceneKey()),
                all);
    }

    private static void refused(String key, Executable wrong) {
        assertEquals(key, assertThrows(InvalidValueException.class, wrong).key());
    }

    @Test
    void valuesOutOfRangeAreRefusedByTheirKey() {
        refused("methods", () -> USUAL.withMethods(List.of()));
        refused("methods", () -> USUAL.withMethods(List.of("guess")));
        refused("methods", () -> USUAL.withMethods(List.of("cluster", "cluster")));
        refused("budget", () -> USUAL.withBudgetSeconds(0));
        refused("budget", () -> USUAL.withBudgetSeconds(Double.NaN));
        refused("budget", () -> USUAL.withBudgetSeconds(Double.POSITIVE_INFINITY));
        refused("seeds", () -> USUAL.withSeeds(0));
        refused("seeds", () -> USUAL.withSeeds(TradeSettings.MAX_SEEDS + 1));
        refused("reference", () -> USUAL.withReference(SyntheticImages.gradient(8, 9)));
        assertThrows(InvalidValueException.class, () -> USUAL.withSweeps(List.of(Sweep.parse("antialias=1..9999"))));
    }
}
