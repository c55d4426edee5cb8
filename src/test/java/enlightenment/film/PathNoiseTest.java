package enlightenment.film;

import enlightenment.color.DisplayCurve;
import org.junit.jupiter.api.Test;

class PathNoiseTest {
    @Test
    void explore() {
        for (PathPicture.Kind kind : PathPicture.Kind.values()) {
            for (double bright : new double[] {0.05, 0.5, 4}) {
                for (int n : new int[] {1, 2, 3, 4, 5, 8, 16, 64}) {
                    int in = 0, low = 0, high = 0;
                    double ratio = 0, rel = 0, share = 0, R = 0, need = 0;
                    int seeds = 20;
                    for (int s = 0; s < seeds; s++) {
                        PathPicture p = PathPicture.of(kind, bright, n, DisplayCurve.SRGB, s);
                        ErrorEstimate e = p.film.error();
                        double t = p.error();
                        low += t < e.low() ? 1 : 0;
                        high += t > e.high() ? 1 : 0;
                        ratio += StrictMath.log(e.rmse() / t) / seeds;
                        rel += e.linear().get().relative() / p.relative() / seeds;
                        share += e.linear().get().kurtosis() / seeds;
                                                R += e.linear().get().hasHeavyTail() ? 1 : 0;
                        
                    }
                    System.out.printf(
                            "%-12s %.2f n=%-3d below %d above %d of %d  est/true %.3f  rel %.3f kurt %.1f R %.2f need %.2f%n",
                            kind, bright, n, low, high, seeds, StrictMath.exp(ratio), rel, share, R, need);
                }
            }
        }
    }
}
