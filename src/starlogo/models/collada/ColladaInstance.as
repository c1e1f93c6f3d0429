package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.TriangleLabels;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** An instance of a geometry in a COLLADA scene. Its steps add it to a model. */
    internal final class ColladaInstance
    {
        private static const VERTICES_PER_STEP:int = 3000;
        private static const TRIANGLES_PER_STEP:int = 5000;

        /** The geometry. Its steps read it. Read only. */
        public var mesh:ColladaMesh;

        // The element that instantiates the geometry. If there is no scene, the geometry's own element.
        private var _element:ColladaElement;

        private var _deformation:ColladaDeformation;

        /**
         * @param element the element that instantiates the geometry; the geometry's own element if there is no scene
         * @param mesh the geometry's vertices and triangles. All instances of a geometry share them
         * @param deformation moves its points
         */
        public function ColladaInstance(element:ColladaElement, mesh:ColladaMesh, deformation:ColladaDeformation)
        {
            _element = element;
            this.mesh = mesh;
            _deformation = deformation;
        }

        /**
         * The steps that add the geometry, which is read already, to a model.
         *
         * @param data takes the vertices, the triangles and what they belong to
         */
        public function adding(data:ModelData):Steps
        {
            return new StepSequence().add(_deformation).begin(function():Steps
                {
                    return addingPoints(_deformation.points, data);
                });
        }

        // The steps that transform points, and add these and the triangles. If the points are mirrored, the triangles' corner order is reversed.
        private function addingPoints(points:Vector.<Number>, data:ModelData):Steps
        {
            var transform:AffineTransform = _deformation.transform;
            var isMirror:Boolean = _deformation.isMirror;
            var firstVertex:int = data.vertices.length / 3;
            var firstTriangle:int = data.triangles.length / 3;
            var vertexCount:int = points.length / 3;
            var triangleCount:int = mesh.triangles.length / 3;
            _element.budget.requireMesh(firstVertex + vertexCount, firstTriangle + triangleCount, _element);
            if (triangleCount > 0)
            {
                addLabels(data, firstTriangle);
            }
            return new StepSequence().slices(vertexCount, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    var areFinite:Boolean = transform.transformPoints(points, first, end, data.vertices, firstVertex + first);
                    _element.refuseIf(!areFinite, "its transformed coordinates are too large: they are not finite numbers");
                }).slices(triangleCount, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = 3 * first; i < 3 * end; i += 3)
                    {
                        var b:int = firstVertex + mesh.triangles[i + 1];
                        var c:int = firstVertex + mesh.triangles[i + 2];
                        data.triangles.push(firstVertex + mesh.triangles[i], isMirror ? c : b, isMirror ? b : c);
                    }
                });
        }

        // The instance is a mesh with the name of its node. Its materials are those that it binds to the symbols of its geometry.
        private function addLabels(data:ModelData, firstTriangle:int):void
        {
            var node:ColladaElement = _element.name != "geometry" && _element.parent != null ? _element.parent : _element;
            _element.budget.spendElements(mesh.symbols.length, _element);
            data.meshes.beginRun(data.meshes.addLabel(nameOf(node) || nameOf(mesh.geometry)), firstTriangle);
            for (var i:int = 0; i < mesh.symbols.length; i++)
            {
                data.materials.beginRun(labelOf(mesh.symbols[i], data.materials), firstTriangle + mesh.starts[i]);
            }
        }

        // The label of the material that is bound to a symbol. A symbol that is not bound counts as a material. -1 for no symbol.
        private function labelOf(symbol:String, materials:TriangleLabels):int
        {
            if (symbol == "")
            {
                return -1;
            }
            var material:ColladaElement = materialOf(symbol);
            // A symbol may be equal to another material's id.
            return material == null ? materials.labelWithKey("symbol " + symbol, symbol) : materials.labelWithKey("material " + material.id, nameOf(material));
        }

        // The material that is bound to a symbol; null if none is bound, or one that is not in this file.
        private function materialOf(symbol:String):ColladaElement
        {
            var binding:ColladaElement = _element.child("bind_material");
            var technique:ColladaElement = binding == null ? null : binding.child("technique_common");
            var bound:ColladaElement = technique == null ? null : technique.child("instance_material", symbol);
            return bound == null ? null : _element.elementAtUrl("material", bound.attribute("target"));
        }

        private static function nameOf(element:ColladaElement):String
        {
            return element.attribute("name") || element.id || null;
        }
    }
}
