package enlightenment.classic.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Distribution;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Warp;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Proposals from clusters: what they are worth does not depend on how good they are. */
class ClusterProposalTest {
    private final double[] disk = new double[3];

    /** Whether a place is in the hole, which moves with the film position and has a part of its own beside it. */
    private static boolean isRare(double x, double y, double p, double q) {
        double a = p - 0.3 - 0.04 * x;
        double b = q + 0.1 - 0.03 * y;
        double c = p + 0.5 - 0.04 * x;
        return a * a + b * b < 0.15 * 0.15 || Math.abs(c) < 0.05 && Math.abs(b) < 0.15;
    }

    /** The exact share of the rare places while both parts lie in the disk: a circle and a rectangle over π. */
    private static final double RARE = (Math.PI * 0.15 * 0.15 + 0.1 * 0.3) / Math.PI;

    private ClusterProposal watching(String family, Random random, int points, boolean rareIsBlocked) {
        ClusterProposal cluster = new ClusterProposal(Distribution.of(family));
        cluster.begin(1, 0, 0);
        for (int k = 0; k < points; k++) {
            double x = 8 * random.nextDouble() - 4;
            double y = 8 * random.nextDouble() - 4;
            Warp.toDisk(random.nextDouble(), random.nextDouble(), disk);
            cluster.watch(x, y, disk[0], disk[1], isRare(x, y, disk[0], disk[1]) == rareIsBlocked);
        }
        return cluster;
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void theShareThatIsFoundWhileLearningIsTheTrueOne(String family) {
        int runs = 250;
        int perRow = 64;
        double sum = 0;
        double squares = 0;
        int fitted = 0;
        for (int run = 0; run < runs; run++) {
            Random random = new Random(Hash.of(run, 1));
            ClusterProposal cluster = watching(family, random, 1500, true);
            if (!cluster.fit()) {
                continue;
            }
            fitted++;
            assertTrue(cluster.wantsBlocked());
            double found = 0;
            for (int row = 0; row < 8; row++) {
                for (int k = 0; k < perRow; k++) {
                    double x = 8 * random.nextDouble() - 4;
                    double y = 8 * random.nextDouble() - 4;
                    assertTrue(cluster.proposes());
                    cluster.aim(x, y);
                    double weight = cluster.propose(random.nextDouble(), random.nextDouble());
                    // At least an eighth of the points is even.
                    assertTrue(weight >= 0 && weight <= 8, "weight " + weight);
                    if (weight > 0 && isRare(x, y, cluster.p, cluster.q)) {
                        found += weight;
                        cluster.accept(x, y, cluster.p, cluster.q, weight);
                    }
                }
                cluster.learn();
            }
            double share = found / (8 * perRow);
            sum += share;
            squares += share * share;
        }
        assertTrue(fitted > runs / 4, fitted + " fits");
        double mean = sum / fitted;
        double deviation = Math.sqrt((squares / fitted - mean * mean) / fitted);
        assertEquals(RARE, mean, 4 * deviation, family);
        // Even points would have √(f (1 − f)/512) in each run: proposals find it with at most 70 % of that.
        assertTrue(deviation < 0.7 * Math.sqrt(RARE * (1 - RARE) / (512 * fitted)), family + ": " + deviation);
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void weightsAreOneInTheMeanSinceTheDiskIsAllThereIs(String family) {
        ClusterProposal cluster = watching(family, new Random(3), 3000, true);
        assertTrue(cluster.fit());
        for (double[] at : new double[][] {{0, 0}, {4, -4}, {-4, 2}}) {
            cluster.aim(at[0], at[1]);
            int n = 800;
            double sum = 0;
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    sum += cluster.propose((i + 0.5) / n, (j + 0.5) / n);
                }
            }
            // The midpoint rule, with jumps where components of the mixture end: about one row of points each.
            assertEquals(1, sum / n / n, 5.0 / n, family);
        }
    }

    /** A lobe of which a good part lies outside the disk: what falls there is lost, and must be. */
    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void weightsAreOneInTheMeanAtTheInterfaceToo(String family) {
        ClusterProposal cluster = new ClusterProposal(Distribution.of(family));
        cluster.begin(1, 0, 0);
        Random random = new Random(6);
        for (int k = 0; k < 2000; k++) {
            Warp.toDisk(random.nextDouble(), random.nextDouble(), disk);
            cluster.watch(0, 0, disk[0], disk[1], disk[0] < 0.93);
        }
        assertTrue(cluster.fit());
        cluster.aim(0, 0);
        int n = 800;
        int outside = 0;
        double sum = 0;
        for (int k = 0; k < n * n; k++) {
            double weight = cluster.propose((k % n + 0.5) / n, (k / n + 0.5) / n);
            outside += weight == 0 ? 1 : 0;
            sum += weight;
        }
        assertTrue(outside > n * n / 30, outside + " outside");
        assertEquals(1, sum / n / n, 5.0 / n, family);
    }

    @Test
    void theRarerKindIsSoughtBeItSeenOrHidden() {
        ClusterProposal hidden = watching("normal", new Random(4), 1500, true);
        ClusterProposal seen = watching("normal", new Random(4), 1500, false);
        assertTrue(hidden.fit());
        assertTrue(seen.fit());
        assertTrue(hidden.wantsBlocked());
        assertFalse(seen.wantsBlocked());
        assertEquals(hidden.rare(), seen.rare());
        assertEquals(hidden.judgedGain(), seen.judgedGain());
        assertTrue(hidden.judgedGain() > 3);
    }

    @Test
    void withoutSomethingToLearnNothingIsProposed() {
        ClusterProposal cluster = new ClusterProposal(Distribution.of("normal"));
        cluster.begin(1, 0, 0);
        assertFalse(cluster.fit());
        assertEquals(1, cluster.judgedGain());
        Random random = new Random(2);
        for (int k = 0; k < 500; k++) {
            Warp.toDisk(random.nextDouble(), random.nextDouble(), disk);
            // Every second point is hidden, wherever it lies: there is nothing to seek.
            cluster.watch(0, 0, disk[0], disk[1], k % 2 == 0);
        }
        assertFalse(cluster.fit());
        assertFalse(cluster.proposes());
    }

    @Test
    void placesThatAreAllTheSameMakeFiniteWeights() {
        for (int kind = 0; kind < 3; kind++) {
            ClusterProposal cluster = new ClusterProposal(Distribution.of("normal"));
            cluster.begin(1, 0, 0);
            for (int k = 0; k < 2000; k++) {
                boolean rare = k % 20 == 0;
                // On one place; on one line; in two places.
                double p = kind == 1 ? k / 2000.0 : kind == 2 && k % 40 == 0 ? -0.5 : 0.5;
                cluster.watch(0, 0, rare ? p : -0.3, rare ? 0 : 0.4, rare);
            }
            boolean proposes = cluster.fit();
            for (int k = 0; proposes && k < 100; k++) {
                cluster.aim(4, -4);
                double weight = cluster.propose(k / 100.0, (k * 37 % 100) / 100.0);
                assertTrue(weight >= 0 && weight <= 8, "kind " + kind + ": " + weight);
                if (weight > 0) {
                    cluster.accept(4, -4, cluster.p, cluster.q, weight);
                }
                cluster.learn();
            }
        }
    }

    @Test
    void aClusterThatBeginsAnewRemembersNothing() {
        ClusterProposal used = watching("normal", new Random(8), 1500, true);
        used.fit();
        used.begin(2, 1, 3);
        assertTrue(used.is(2, 1, 3));
        assertFalse(used.is(1, 0, 0));
        assertEquals(0, used.watched());
        assertFalse(used.proposes());
        assertFalse(used.fit());
    }
}
