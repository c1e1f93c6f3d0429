package starlogo.models.collada
{
    import starlogo.data.keyOf;
    import starlogo.models.building.TriangleLabels;
    import starlogo.models.polygons.Triangulator;
    import starlogo.models.scene.SceneMesh;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The mesh of a COLLADA geometry: its primitives with a surface. Splines, solids and lines have none. A geometry without a surface has its points
     * alone.
     */
    internal final class ColladaMesh extends SceneMesh
    {
        private static const SURFACES:Array = ["triangles", "polylist", "polygons", "tristrips", "trifans"];

        // the points of each source, by keyOf() its id: several primitives may share them
        private var _pointsOfSources:Object = {};

        /** @param geometry the geometry's element */
        public function ColladaMesh(geometry:ColladaElement)
        {
            var element:ColladaElement = geometry.child("mesh") || geometry.child("convex_mesh");
            var hasSurface:Boolean = false;
            for each (var child:ColladaElement in element == null ? null : element.children)
            {
                // some programs write empty primitives without inputs
                if (SURFACES.indexOf(child.name) >= 0 && child.attribute("count") != "0")
                {
                    hasSurface = true;
                    addPrimitive(child);
                }
            }
            var vertices:ColladaElement = element == null || hasSurface ? null : element.child("vertices");
            if (vertices != null)
            {
                begin(function():Steps
                    {
                        return pointsOf(vertices);
                    });
            }
        }

        /** @inheritDoc It is the material that the instance binds to the symbol. A symbol that is not bound counts as a material. */
        override public function labelOf(symbol:String, instance:Object, labels:TriangleLabels):int
        {
            var element:ColladaElement = ColladaElement(instance);
            element.budget.spendElements(1, element);
            if (symbol == "")
            {
                return -1;
            }
            var binding:ColladaElement = element.child("bind_material");
            var technique:ColladaElement = binding == null ? null : binding.child("technique_common");
            var bound:ColladaElement = technique == null ? null : technique.child("instance_material", symbol);
            // null if none is bound, or one that is not in this file
            var material:ColladaElement = bound == null ? null : element.elementAt("material", bound.attribute("target"));
            // a symbol may be equal to another material's id
            return material == null ? labels.labelWithKey("symbol " + symbol, symbol) : labels.labelWithKey("material " + material.id, material.nameOrId);
        }

        private function addPrimitive(element:ColladaElement):void
        {
            begin(function():Steps
                {
                    var positions:ColladaAccessor = pointsOf(ColladaPrimitive.positionInput(element).target("source", ["vertices", "source"], element.parent));
                    beginPrimitive(element.attribute("material"));
                    return new StepSequence().add(positions).add(new ColladaPrimitive(element, positions, new Triangulator(element.budget, points, corners)));
                });
        }

        // The points of a source, or of the source that an element "vertices" refers to. They are read once.
        private function pointsOf(element:ColladaElement):ColladaAccessor
        {
            var source:ColladaElement = element.name == "source" ? element : element.requiredInput("POSITION").target("source", ["source"], element.parent);
            return _pointsOfSources[keyOf(source.id)] ||= new ColladaAccessor(source, ColladaAccessor.NUMBERS, points);
        }
    }
}
