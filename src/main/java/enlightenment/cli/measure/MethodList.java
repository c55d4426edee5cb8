package enlightenment.cli.measure;

import enlightenment.cli.option.BadValue;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;

/** Methods to compare, each at most once. */
record MethodList(List<Method> methods) {
    /** The built-in methods that can render a scene. If none can, those for its shading, so that the caller can report why each cannot. */
    static MethodList oursFor(Scene scene) {
        List<Method> ours = List.copyOf(BuiltInMethod.rendering(scene.shading().model()));
        List<Method> able =
                ours.stream().filter(method -> Method.supports(method, scene)).toList();
        return new MethodList(able.isEmpty() ? ours : able);
    }

    /** As it is typed: {@code raytrace,cluster}. */
    @Override
    public String toString() {
        return methods.stream().map(Method::word).collect(Collectors.joining(","));
    }

    /** Reads names with commas between them. */
    static final class Converter implements ITypeConverter<MethodList> {
        @Override
        public MethodList convert(String text) {
            List<Method> methods = new ArrayList<>();
            for (String word : text.split(",", -1)) {
                Method method = Method.of(word)
                        .orElseThrow(() -> BadValue.expected("some of " + new MethodList(Method.all()), text));
                if (methods.contains(method)) {
                    throw new BadValue("must name each method once, not \"" + text + "\"");
                }
                methods.add(method);
            }
            return new MethodList(List.copyOf(methods));
        }
    }
}
