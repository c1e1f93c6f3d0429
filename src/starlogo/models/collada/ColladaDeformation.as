package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.ModelError;
    import starlogo.models.files.shortened;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Moves the points of a COLLADA geometry by the morphs and skins of its controllers, if it has any, in steps. At rest a morph is its base shape, and if a
     * skin is wrong, or too much for the limits, the points are where it was bound: what does not move needs no joints.
     */
    internal final class ColladaDeformation extends StepSequence
    {
        /** The points, when no step is left. */
        public var points:Vector.<Number> = null;

        /** What takes these points to the scene, when no step is left. */
        public var transform:AffineTransform;

        private var _isFirstJointMirror:Boolean = false;
        private var _scene:ColladaScene;
        private var _mesh:ColladaMesh;
        private var _bindTransform:AffineTransform; // takes the points of the geometry to where its skins were bound

        /**
         * @param scene knows where joints are, and the pose
         * @param instance the element that instantiates the geometry
         * @param node the node with this element; null if there is no scene
         * @param mesh the geometry, which is read before the first step
         * @param deformers the morphs and skins, the last one first; empty for a geometry that the node places
         */
        public function ColladaDeformation(scene:ColladaScene, instance:ColladaElement, node:ColladaNode, mesh:ColladaMesh, deformers:Vector.<ColladaElement>)
        {
            _scene = scene;
            _mesh = mesh;
            _bindTransform = transform = node == null ? new AffineTransform() : node.transform;
            call(function():void
                {
                    points = deformers.length == 0 ? mesh.points : mesh.points.slice();
                });
            for (var i:int = deformers.length - 1; i >= 0; i--)
            {
                addDeformer(deformers[i], instance, node);
            }
            for each (var deformer:ColladaElement in deformers)
            {
                _bindTransform = deformer.name == "skin" ? _bindTransform.after(scene.document.skinOf(deformer).bindShape) : _bindTransform;
            }
        }

        /** Whether the points are mirrored, when no step is left: by the transform, or by the first joint of the last skin. */
        public function get isMirror():Boolean
        {
            return transform.isMirror || _isFirstJointMirror;
        }

        /** @inheritDoc */
        override public function step():Boolean
        {
            try
            {
                return super.step();
            }
            catch (error:ModelError)
            {
                if (!_scene.isAtRest)
                {
                    throw error;
                }
            }
            points = _mesh.points;
            transform = _bindTransform;
            _isFirstJointMirror = false;
            return false;
        }

        private function addDeformer(deformer:ColladaElement, instance:ColladaElement, node:ColladaNode):void
        {
            if (deformer.name == "skin")
            {
                var skin:ColladaSkin = _scene.document.skinOf(deformer);
                // the joints put the points into the scene
                transform = new AffineTransform();
                add(skin).begin(function():Steps
                    {
                        var jointMatrices:Vector.<AffineTransform> = skin.jointMatricesOf(_scene, node, instance);
                        _isFirstJointMirror = jointMatrices[0].isMirror;
                        return skin.moving(points, jointMatrices);
                    });
            }
            else if (!_scene.isAtRest)
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
            var posed:Vector.<Number> = _scene.posedNumbersOf(list.array);
            var weights:Vector.<Number> = posed == null ? list.numbers : list.partOf(posed);
            morph.refuseIf(targets.words.length > weights.length, "it has " + targets.words.length + " targets, but " + weights.length + " weights");
            var base:Vector.<Number> = morph.attribute("method") == "RELATIVE" ? new Vector.<Number>(points.length) : points.slice();
            return new StepSequence().beginEach(targets.words.length, function(index:int):Steps
                {
                    var target:ColladaMesh = targetOf(morph, targets.words[index]);
                    return new StepSequence().add(target).call(function():void
                        {
                            morph.refuseIf(target.points.length != points.length, "its target \"" + shortened(targets.words[index]) + "\" has another number of points");
                            morph.budget.spendNumbers(points.length, morph);
                            for (var i:int = 0; i < points.length; i++)
                            {
                                points[i] += weights[index] * (target.points[i] - base[i]);
                            }
                        });
                });
        }

        private function targetOf(morph:ColladaElement, id:String):ColladaMesh
        {
            var geometry:ColladaElement = morph.elementWith("geometry", id);
            morph.refuseIf(geometry == null, "there is no <geometry> with the id \"" + shortened(id) + "\"");
            return _scene.document.meshOf(geometry);
        }
    }
}
