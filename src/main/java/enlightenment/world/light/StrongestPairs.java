package enlightenment.world.light;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Keeps the few pairs of mirror and light with the largest power; of equal ones those with the least mirror id, then the least light. */
public final class StrongestPairs {
    /** A mirror's id, a light's index, and the power that goes from the light to the mirror. */
    public record Pair(int id, int light, double power) {
        boolean isBefore(double otherPower, int otherId, int otherLight) {
            return power != otherPower ? power > otherPower : id != otherId ? id < otherId : light < otherLight;
        }
    }

    private final int most;
    private final List<Pair> pairs = new ArrayList<>();

    /**
     * @param most the number of pairs to keep
     */
    public StrongestPairs(int most) {
        this.most = most;
    }

    /** Whether a pair would be kept now. If not, none that is ordered after it will ever be kept. */
    boolean takes(double power, int id, int light) {
        return pairs.size() < most || !pairs.get(most - 1).isBefore(power, id, light);
    }

    /** Keeps a pair that was not offered before, if it is one of the strongest. */
    void offer(double power, int id, int light) {
        if (takes(power, id, light)) {
            int place = pairs.size();
            while (place > 0 && !pairs.get(place - 1).isBefore(power, id, light)) {
                place--;
            }
            pairs.add(place, new Pair(id, light, power));
            if (pairs.size() > most) {
                pairs.remove(most);
            }
        }
    }

    /** The pairs kept, in order of power. */
    public List<Pair> byPower() {
        return List.copyOf(pairs);
    }

    /** The pairs kept, in order of id and light. */
    public List<Pair> byId() {
        return pairs.stream()
                .sorted(Comparator.comparingInt(Pair::id).thenComparingInt(Pair::light))
                .toList();
    }
}
