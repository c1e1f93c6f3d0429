package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.ModelError;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.TriangleLabels;
    import starlogo.models.files.shortened;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * An instance of a geometry in a COLLADA scene. Its steps move the points by the morphs and skins of its controllers, if it has any. At rest a
     * morph is its base shape, and if a skin is wrong, or too much for the limits, the points are where it was bound: what does not move needs no
     * joints. More steps add the instance to a model.
     */
    internal final class ColladaInstance extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 3000;
        private static const TRIANGLES_PER_STEP:int = 5000;

        /** The geometry. Its steps read it. Read only. */
        public var mesh:ColladaMesh;

        // The element that instantiates the geometry. If there is no scene, the geometry's own element.
        private var _element:ColladaElement;

        private var _reader:ColladaReader;

        // The points, which are moved: null for those of the geometry. What takes them to the scene, and whether the first joint of the last skin mirrors
        // them.
        private var _points:Vector.<Number> = null;
        private var _transform:AffineTransform;
        private var _isFirstJointMirror:Boolean = false;

        private var _bindTransform:AffineTransform; // takes the points of the geometry to where its skins were bound

        /**
         * @param reader knows where joints are, and the pose
         * @param element the element that instantiates the geometry; the geometry's own element if there is no scene
         * @param node the node with this element; null if there is no scene
         * @param mesh the geometry, which is read before the first step. All instances of a geometry share it
         * @param deformers the morphs and skins, the last one first; empty for a geometry that the node places
         */
        public function ColladaInstance(reader:ColladaReader, element:ColladaElement, node:ColladaNode, mesh:ColladaMesh, deformers:Vector.<ColladaElement>)
        {
            _reader = reader;
            _element = element;
            this.mesh = mesh;
            _bindTransform = _transform = node == null ? new AffineTransform() : node.transform;
            if (deformers.length > 0)
            {
                call(function():void
                    {
                        _points = mesh.points.slice();
                    });
            }
            for (var i:int = deformers.length - 1; i >= 0; i--)
            {
                addDeformer(deformers[i], node);
            }
            for each (var deformer:ColladaElement in deformers)
            {
                _bindTransform = deformer.name == "skin" ? _bindTransform.after(reader.document.skinOf(deformer).bindShape) : _bindTransform;
            }
        }

        /**
         * The steps that move the points, and then add the geometry, which is read already, to a model.
         *
         * @param data takes the vertices, the triangles and what they belong to
         */
        public function adding(data:ModelData):Steps
        {
            return new StepSequence().add(this).begin(function():Steps
                {
                    return addingPoints(data);
                });
        }

        /** @inheritDoc At rest, a step that fails is the last one: the points are then where they were bound. */
        override public function step():Boolean
        {
            try
            {
                return super.step();
            }
            catch (error:ModelError)
            {
                if (!_reader.isAtRest)
                {
                    throw error;
                }
                _points = null;
                _transform = _bindTransform;
                _isFirstJointMirror = false;
            }
            return false;
        }

        private function addDeformer(deformer:ColladaElement, node:ColladaNode):void
        {
            if (deformer.name == "skin")
            {
                var skin:ColladaSkin = _reader.document.skinOf(deformer);
                // the joints put the points into the scene
                _transform = new AffineTransform();
                add(skin).begin(function():Steps
                    {
                        var jointMatrices:Vector.<AffineTransform> = skin.jointMatricesOf(_reader, node, _element);
                        _isFirstJointMirror = jointMatrices[0].isMirror;
                        return skin.moving(_points, jointMatrices);
                    });
            }
            else if (!_reader.isAtRest)
            {
                begin(function():Steps
                    {
                        return morphing(deformer);
                    });
            }
        }

        // The targets of a relative morph are added. Other targets share the shape with the base, whose weight is the rest.
        private function morphing(morph:ColladaElement):Steps
        {
            var inputs:ColladaElement = morph.requiredChild("targets");
            var targets:ColladaAccessor = ColladaAccessor.read(inputs, "MORPH_TARGET", ColladaAccessor.NAMES, morph);
            var list:ColladaAccessor = ColladaAccessor.read(inputs, "MORPH_WEIGHT", ["float_array"], morph);
            var posed:Vector.<Number> = _reader.posedNumbersOf(list.array);
            var weights:Vector.<Number> = posed == null ? list.toNumbers() : list.partOf(posed);
            morph.refuseIf(targets.words.length > list.count, "it has " + targets.words.length + " targets, but " + list.count + " weights");
            var base:Vector.<Number> = morph.attribute("method") == "RELATIVE" ? new Vector.<Number>(_points.length) : _points.slice();
            return new StepSequence().beginEach(targets.words.length, function(index:int):Steps
                {
                    var geometry:ColladaElement = morph.elementAt("geometry", "#" + targets.words[index]);
                    morph.refuseIf(geometry == null, "there is no <geometry> with the id \"" + shortened(targets.words[index]) + "\"");
                    var target:ColladaMesh = _reader.document.meshOf(geometry);
                    return new StepSequence().add(target).call(function():void
                        {
                            morph.refuseIf(target.points.length != _points.length, "its target \"" + shortened(targets.words[index]) + "\" has another number of points");
                            morph.budget.spendNumbers(_points.length, morph);
                            for (var i:int = 0; i < _points.length; i++)
                            {
                                _points[i] += weights[index * list.stride] * (target.points[i] - base[i]);
                            }
                        });
                });
        }

        // The steps that transform points, and add these and the triangles. If the points are mirrored, the triangles' corner order is reversed.
        private function addingPoints(data:ModelData):Steps
        {
            var points:Vector.<Number> = _points || mesh.points;
            var transform:AffineTransform = _transform;
            var isMirror:Boolean = transform.isMirror || _isFirstJointMirror;
            var firstVertex:int = data.vertices.length / 3;
            var firstTriangle:int = data.triangles.length / 3;
            var vertexCount:int = points.length / 3;
            var triangleCount:int = mesh.triangles.length / 3;
            _element.budget.checkMeshSize(firstVertex + vertexCount, firstTriangle + triangleCount, _element);
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
                data.materials.beginRun(labelOf(mesh.symbols[i], data.materials), firstTriangle + mesh.firstTriangles[i]);
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
            return bound == null ? null : _element.elementAt("material", bound.attribute("target"));
        }

        private static function nameOf(element:ColladaElement):String
        {
            return element.attribute("name") || element.id || null;
        }
    }
}
