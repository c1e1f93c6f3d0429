package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.TriangleLabels;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** A geometry at a place in a COLLADA scene, which can add it to a model. */
    internal final class ColladaInstance
    {
        private static const VERTICES_PER_STEP:int = 3000;
        private static const TRIANGLES_PER_STEP:int = 5000;

        // The element that places the geometry. If there is no scene, the geometry's own element.
        private var _element:ColladaElement;

        private var _mesh:ColladaMesh;
        private var _transform:AffineTransform;
        private var _deformation:ColladaDeformation;

        /**
         * @param element the element that places the geometry; the geometry's own element if there is no scene
         * @param mesh the geometry's vertices and triangles. All instances of a geometry share them
         * @param transform takes its points to the scene, unless there is a deformation
         * @param deformation moves its points first; null for none
         */
        public function ColladaInstance(element:ColladaElement, mesh:ColladaMesh, transform:AffineTransform, deformation:ColladaDeformation = null)
        {
            _element = element;
            _mesh = mesh;
            _transform = transform;
            _deformation = deformation;
        }

        /** The geometry. Its steps read it. */
        public function get mesh():ColladaMesh
        {
            return _mesh;
        }

        /**
         * The steps that add the geometry, which is read already, to a model.
         *
         * @param data takes the vertices, the triangles and what they belong to
         * @param loosePoints takes the points of a geometry without triangles
         */
        public function adding(data:ModelData, loosePoints:Vector.<Number>):Steps
        {
            var work:StepSequence = new StepSequence();
            if (_deformation != null)
            {
                work.add(_deformation);
            }
            return work.begin(function():Steps
                {
                    var out:Vector.<Number> = _mesh.triangles.length > 0 ? data.vertices : loosePoints;
                    return _deformation == null ? addingPoints(_mesh.vertices, _transform, _transform.isMirror, data, out)
                        : addingPoints(_deformation.points, _deformation.transform, _deformation.isMirror, data, out);
                });
        }

        // The steps that transform points, and add these and the triangles. If the points are mirrored, the triangles' corner order is reversed.
        private function addingPoints(points:Vector.<Number>, transform:AffineTransform, isMirror:Boolean, data:ModelData, out:Vector.<Number>):Steps
        {
            var firstVertex:int = out.length / 3;
            var firstCorner:int = data.triangles.length;
            var vertexCount:int = points.length / 3;
            var triangleCount:int = _mesh.triangles.length / 3;
            _element.limits.requireMesh(firstVertex + vertexCount, firstCorner / 3 + triangleCount, _element);
            if (triangleCount > 0)
            {
                addLabels(data, firstCorner / 3);
            }
            return new StepSequence().slices(vertexCount, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    var areFinite:Boolean = transform.transformPoints(points, first, end, out, firstVertex + first);
                    _element.refuseIf(!areFinite, "its transformed coordinates are too large: they are not finite numbers");
                }).slices(triangleCount, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    addTriangles(data.triangles, 3 * first, 3 * end, firstVertex, firstCorner, isMirror);
                });
        }

        // The instance is a mesh with the name of its node. Its materials are those that it binds to the symbols of its geometry.
        private function addLabels(data:ModelData, firstTriangle:int):void
        {
            var node:ColladaElement = _element.name != "geometry" && _element.parent != null ? _element.parent : _element;
            _element.limits.countElements(_mesh.symbols.length, _element);
            data.meshes.beginRun(data.meshes.addLabel(nameOf(node) || nameOf(_mesh.geometry)), firstTriangle);
            for (var i:int = 0; i < _mesh.symbols.length; i++)
            {
                data.materials.beginRun(labelOf(_mesh.symbols[i], data.materials), firstTriangle + _mesh.starts[i]);
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

        private function addTriangles(to:Vector.<uint>, first:int, last:int, firstVertex:int, firstCorner:int, isMirror:Boolean):void
        {
            var from:Vector.<uint> = _mesh.triangles;
            var at:int = firstCorner + first;
            var second:int = isMirror ? 2 : 1;
            var third:int = 3 - second;
            for (var i:int = first; i < last; i += 3)
            {
                to[at] = from[i] + firstVertex;
                to[int(at + 1)] = from[int(i + second)] + firstVertex;
                to[int(at + 2)] = from[int(i + third)] + firstVertex;
                at += 3;
            }
        }
    }
}
