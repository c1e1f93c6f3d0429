package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.ModelError;
    import starlogo.models.files.shortened;
    import starlogo.models.scene.DeformedPoints;
    import starlogo.models.scene.SceneMesh;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The skins and morphs between a node and a geometry: it follows an <code>instance_controller</code> from controller to controller.
     */
    internal final class ColladaController
    {
        private static const MAX_DEFORMERS:int = 16;

        /** The geometry's element. */
        public var geometry:ColladaElement;

        private var _scene:ColladaScene;
        private var _instance:ColladaElement;
        private var _node:int;

        // the elements of the skins and morphs, the first one nearest to the node
        private var _deformers:Vector.<ColladaElement> = new Vector.<ColladaElement>();

        /**
         * @param scene has the node
         * @param instance the instance_controller
         * @param node the instance's node
         * @throws ModelError if there is no geometry, or a bind shape matrix is wrong
         */
        public function ColladaController(scene:ColladaScene, instance:ColladaElement, node:int)
        {
            _scene = scene;
            _instance = instance;
            _node = node;
            geometry = instance.target("url", ["controller"]);
            while (geometry.name == "controller")
            {
                instance.budget.spendElements(ColladaScene.ELEMENTS_PER_NODE, instance);
                var deformer:ColladaElement = geometry.child("skin") || geometry.requiredChild("morph");
                geometry = deformer.target("source", ["geometry", "controller"]);
                instance.refuseIf(_deformers.length == MAX_DEFORMERS, "more than " + MAX_DEFORMERS +
                        " controllers follow one another, or they refer to each other in a circle");
                _deformers.push(deformer);
                if (deformer.name == "skin")
                {
                    scene.skinOf(deformer); // so that a wrong matrix is refused now
                }
            }
        }

        /**
         * The steps that move the points of the instance. The last skin or morph moves them first. At rest the points are where they were bound if a skin
         * is wrong, or too much for the limits: what does not move needs no joints.
         */
        public function deforming(deformed:DeformedPoints):Steps
        {
            var work:StepSequence = new StepSequence().beginEach(_deformers.length, function(index:int):Steps
                {
                    var deformer:ColladaElement = _deformers[_deformers.length - 1 - index];
                    return deformer.name == "skin" ? skinning(deformed, _scene.skinOf(deformer)) : morphing(deformed, deformer);
                });
            return new StepSequence().repeat(function():Boolean
                {
                    try
                    {
                        return work.step();
                    }
                    catch (error:ModelError)
                    {
                        if (_scene.isPosed)
                        {
                            throw error;
                        }
                        deformed.reset(boundTransform());
                    }
                    return false;
                });
        }

        // What takes points to where the skins were bound, at the node.
        private function boundTransform():AffineTransform
        {
            var transform:AffineTransform = _scene.transformOf(_node);
            for each (var deformer:ColladaElement in _deformers)
            {
                transform = deformer.name == "skin" ? transform.after(_scene.skinOf(deformer).bindShape) : transform;
            }
            return transform;
        }

        private function skinning(deformed:DeformedPoints, skin:ColladaSkin):Steps
        {
            return new StepSequence().add(skin).begin(function():Steps
                {
                    var count:int = skin.influences.offsets.length - 1;
                    var pointCount:int = deformed.points.length / 3;
                    skin.element.refuseIf(pointCount != count, "it has weights for " + count + " points, but its geometry has " + pointCount);
                    return deformed.skinning(skin.influences, skin.jointMatricesOf(_scene, _node, _instance), skin.element.budget, skin.element);
                });
        }

        // At rest a morph is its base shape. The targets of a relative morph are added. Other targets share the shape with the base, whose weight is the rest.
        private function morphing(deformed:DeformedPoints, morph:ColladaElement):Steps
        {
            if (!_scene.isPosed)
            {
                return null;
            }
            var inputs:ColladaElement = morph.requiredChild("targets");
            var targets:ColladaAccessor = ColladaAccessor.read(inputs, "MORPH_TARGET", ColladaAccessor.NAMES, morph);
            var list:ColladaAccessor = ColladaAccessor.read(inputs, "MORPH_WEIGHT", ["float_array"], morph);
            var numbers:Vector.<Number> = _scene.posed(String(list.array.index));
            var weights:Vector.<Number> = numbers == null ? list.toNumbers() : list.partOf(numbers);
            morph.refuseIf(targets.words.length > list.count, "it has " + targets.words.length + " targets, but " + list.count + " weights");
            var base:Vector.<Number> = morph.attribute("method") == "RELATIVE" ? null : deformed.points.slice();
            return new StepSequence().beginEach(targets.words.length, function(index:int):Steps
                {
                    var id:String = shortened(targets.words[index]);
                    var targetGeometry:ColladaElement = morph.elementAt("geometry", "#" + targets.words[index]);
                    morph.refuseIf(targetGeometry == null, "there is no <geometry> with the id \"" + id + "\"");
                    var target:SceneMesh = _scene.meshOf(targetGeometry);
                    return new StepSequence().add(target).begin(function():Steps
                        {
                            morph.refuseIf(target.points.length != deformed.points.length, "its target \"" + id + "\" has another number of points");
                            morph.budget.spendNumbers(target.points.length, morph);
                            return deformed.morphing(0, weights[index * list.stride], target.points, base);
                        });
                });
        }
    }
}
