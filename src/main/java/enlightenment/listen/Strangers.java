package enlightenment.listen;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The bounded places of connections that have not authenticated yet. A new one always gets a place: where none is free, the
 * oldest connection of the address that has the most loses its own, so that neither idle connections nor a single address
 * can shut out anybody else. Not
 * for use by several threads at once.
 *
 * @param <T> what has a place
 */
public final class Strangers<T> {
    private final int limit;
    private final int limitOfAddress;

    /** Who has a place, the oldest first, and by which address. */
    private final Map<T, String> places = new LinkedHashMap<>();

    private final Map<String, Integer> counts = new HashMap<>();

    public Strangers(int limit, int limitOfAddress) {
        this.limit = limit;
        this.limitOfAddress = limitOfAddress;
    }

    /**
     * The number of places: at most a quarter of the files that this process may open, as the rest serves what matters more.
     *
     * @param descriptors how many files it may open; 0 if that is not known
     */
    public static int places(int wanted, long descriptors) {
        return descriptors <= 0 ? wanted : (int) Math.max(Math.min(wanted, descriptors / 4), 1);
    }

    /** What counts as one address: of IPv6 the half that a network gives to each of its customers. */
    public static String addressOf(InetAddress address) {
        return address instanceof Inet6Address
                ? HexFormat.of().formatHex(address.getAddress(), 0, 8)
                : address.getHostAddress();
    }

    /** Gives a place; returns those who lost theirs for it. */
    public List<T> add(T who, String address) {
        List<T> gone = new ArrayList<>();
        if (counts.getOrDefault(address, 0) >= limitOfAddress) {
            gone.add(oldestOf(address));
        } else if (places.size() >= limit) {
            gone.add(oldest());
        }
        gone.forEach(this::remove);
        places.put(who, address);
        counts.merge(address, 1, Integer::sum);
        return gone;
    }

    /** The one whose place is the next to be lost; null if there is none. */
    public T oldest() {
        String crowded = null;
        int count = 0;
        for (String address : places.values()) {
            if (counts.get(address) > count) {
                crowded = address;
                count = counts.get(address);
            }
        }
        return crowded == null ? null : oldestOf(crowded);
    }

    private T oldestOf(String address) {
        for (Map.Entry<T, String> place : places.entrySet()) {
            if (place.getValue().equals(address)) {
                return place.getKey();
            }
        }
        throw new IllegalStateException("an address with places has an oldest one");
    }

    /** The place is free; nothing if it was. */
    public void remove(T who) {
        String address = places.remove(who);
        if (address != null) {
            counts.computeIfPresent(address, (a, n) -> n == 1 ? null : n - 1);
        }
    }

    public boolean contains(T who) {
        return places.containsKey(who);
    }

    int size() {
        return places.size();
    }

    public List<T> list() {
        return List.copyOf(places.keySet());
    }
}
