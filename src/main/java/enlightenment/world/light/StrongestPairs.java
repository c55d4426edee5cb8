package enlightenment.world.light;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Of pairs of a mirror and a light the few with the largest power; of equals those with the least id, then the least light. */
public final class StrongestPairs {
    /** A mirror by its id, a light by its index, and what power goes from the one to the other. */
    public record Pair(int id, int light, double power) {
        boolean isBefore(double otherPower, int otherId, int otherLight) {
            return power != otherPower ? power > otherPower : id != otherId ? id < otherId : light < otherLight;
        }
    }

    private final int most;
    private final List<Pair> pairs = new ArrayList<>();

    /** @param most how many are kept */
    public StrongestPairs(int most) {
        this.most = most;
    }

    /** Whether a pair would be kept now. One that comes after it, by power, id and light, is kept at no time if this one is not. */
    boolean takes(double power, int id, int light) {
        return pairs.size() < most || !pairs.get(most - 1).isBefore(power, id, light);
    }

    /** Keeps a pair, which has not been offered before, if it is one of the best. */
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

    /** Those kept, by power. */
    public List<Pair> byPower() {
        return List.copyOf(pairs);
    }

    /** Those kept, by id and light. */
    public List<Pair> byId() {
        return pairs.stream()
                .sorted(Comparator.comparingInt(Pair::id).thenComparingInt(Pair::light))
                .toList();
    }
}
