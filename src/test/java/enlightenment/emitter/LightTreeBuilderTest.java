package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

class LightTreeBuilderTest {
    private static LightNode[] at(Vec3... centers) {
        LightNode[] leaves = new LightNode[centers.length];
        for (int i = 0; i < leaves.length; i++) {
            leaves[i] = LightNode.leaf(centers[i], 0.01, Vec3.ZERO, 1 + i, i);
        }
        return leaves;
    }

    private static Vec3[] random(int n) {
        Random random = new Random(5);
        Vec3[] all = new Vec3[n];
        for (int i = 0; i < n; i++) {
            all[i] = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble());
        }
        return all;
    }

    /** The lights below a node, whose bounds must hold each of them. */
    private static List<Integer> lights(LightNode n) {
        List<Integer> all = new ArrayList<>();
        if (n.light >= 0) {
            all.add(n.light);
            return all;
        }
        for (LightNode child : new LightNode[] {n.first, n.second}) {
            assertTrue(n.box.contains(child.box.min()) && n.box.contains(child.box.max()));
            assertTrue(n.normals.angle() >= child.normals.angle());
            all.addAll(lights(child));
        }
        assertEquals(n.first.strength + n.second.strength, n.strength);
        return all;
    }

    private static int depth(LightNode n) {
        return n.light >= 0 ? 0 : 1 + Math.max(depth(n.first), depth(n.second));
    }

    @Test
    void eachLightIsInTheTreeOnce() {
        for (int n : new int[] {1, 2, 3, 17, 5000}) {
            List<Integer> found = lights(LightTreeBuilder.build(at(random(n)), () -> {}));
            assertEquals(n, found.size());
            assertEquals(n, found.stream().distinct().count());
        }
    }

    @Test
    void distantClustersArePartedFirst() {
        Vec3[] centers = random(40);
        for (int i = 0; i < centers.length; i += 4) {
            centers[i] = centers[i].plus(new Vec3(0, 50, 0));
        }
        LightNode root = LightTreeBuilder.build(at(centers), () -> {});
        List<Integer> low = lights(root.first);
        assertEquals(30, low.size());
        assertTrue(low.stream().allMatch(i -> i % 4 != 0));
        assertTrue(lights(root.second).stream().allMatch(i -> i % 4 == 0));
    }

    @Test
    void lightsInOnePlaceAreHalvedByNumber() {
        Vec3[] centers = new Vec3[1024];
        java.util.Arrays.fill(centers, new Vec3(1, 2, 3));
        LightNode root = LightTreeBuilder.build(at(centers), () -> {});
        assertEquals(1024, lights(root).size());
        assertEquals(10, depth(root));
    }

    @Test
    void coneOfAllDirectionsHoldsTheMeasureOfItsFormula() {
        assertEquals(new NormalCone(Vec3.Y, Math.PI).measure(), NormalCone.ALL.measure());
        // No normal is excluded, so that no direction of the sphere is: 4π.
        assertEquals(4 * Math.PI, NormalCone.ALL.measure(), 1e-12);
    }

    @Test
    void buildingEndsByWhatPollingThrows() {
        assertThrows(
                CancellationException.class,
                () -> LightTreeBuilder.build(at(random(3000)), () -> {
                    throw new CancellationException();
                }));
    }
}
