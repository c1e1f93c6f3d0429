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

        private var _transform:AffineTransform;
        private var _deformation:ColladaDeformation;

        /**
         * @param element the element that instantiates the geometry; the geometry's own element if there is no scene
         * @param mesh the geometry's vertices and triangles. All instances of a geometry share them
         * @param transform takes its points to the scene, unless there is a deformation
         * @param deformation moves its points first; null for none
         */
        public function ColladaInstance(element:ColladaElement, mesh:ColladaMesh, transform:AffineTransform, deformation:ColladaDeformation = null)
        {
            _element = element;
            this.mesh = mesh;
            _transform = transform;
            _deformation = deformation;
        }

        /**
         * The steps that add the geometry, which is read already, to a model.
         *
         * @param data takes the vertices, the triangles and what they belong to
         */
        public function adding(data:ModelData):Steps
        {
            var work:StepSequence = new StepSequence();
            if (_deformation != null)
            {
                work.add(_deformation);
            }
            return work.begin(function():Steps
                {
                    return _deformation == null ? addingPoints(mesh.points, _transform, _transform.isMirror, data)
                        : addingPoints(_deformation.points, _deformation.transform, _deformation.isMirror, data);
                });
        }

        // The steps that transform points, and add these and the triangles. If the points are mirrored, the triangles' corner order is reversed.
        private function addingPoints(points:Vector.<Number>, transform:AffineTransform, isMirror:Boolean, data:ModelData):Steps
        {
            var firstVertex:int = data.vertices.length / 3;
            var firstTriangle:int = data.triangles.length / 3;
            var vertexCount:int = points.length / 3;
            var triangleCount:int = mesh.triangles.length / 3;
            var second:int = isMirror ? 2 : 1;
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
                        data.triangles.push(firstVertex + mesh.triangles[i], firstVertex + mesh.triangles[i + second],
                                firstVertex + mesh.triangles[i + 3 - second]);
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
