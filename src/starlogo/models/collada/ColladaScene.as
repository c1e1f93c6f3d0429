package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.animation.Pose;
    import starlogo.models.files.shortened;
    import starlogo.steps.StepSequence;

    /**
     * The scene of a COLLADA document, at rest or in a pose. Its steps visit the nodes and find where they are, and their
     * geometries. If there is no scene, it takes all geometries of the library.
     */
    internal final class ColladaScene extends StepSequence
    {
        private static const ELEMENTS_PER_STEP:int = 100;
        private static const MAX_DEPTH:int = 256;
        private static const MAX_CONTROLLERS:int = 16;

        // a placed element takes more memory than an element
        private static const COUNT_PER_PLACING:int = 2;

        /** The geometries in the document's order, when no step is left. */
        public var instances:Vector.<ColladaInstance> = new Vector.<ColladaInstance>();

        /** The document. Its scenes share its geometries and skins. Read only. */
        public var document:ColladaDocument;

        private var _places:Object = {}; // lists of the places of a node, in their order, by the node's index

        private var _pose:Pose;

        // The innermost place around the next element, null at the end; and how many there were so far.
        private var _place:ColladaPlace = null;
        private var _placeCount:int = 0;

        /**
         * @param document the document; all its steps must be done
         * @param pose the pose, whose targets are the elements' indices; null at rest
         */
        public function ColladaScene(document:ColladaDocument, pose:Pose)
        {
            this.document = document;
            _pose = pose;
            var scene:ColladaElement = document.root.child("scene");
            var instance:ColladaElement = scene == null ? null : scene.child("instance_visual_scene");
            if (instance != null)
            {
                enter(instance.target("url", ["visual_scene"]));
                repeat(visitSome);
            }
            else
            {
                for each (var geometry:ColladaElement in document.entriesOf("library_geometries", "geometry"))
                {
                    instances.push(new ColladaInstance(geometry, document.meshOf(geometry), new AffineTransform()));
                }
            }
        }

        /** Whether there is no pose. */
        public function get isAtRest():Boolean
        {
            return _pose == null;
        }

        /** The numbers of an element in the pose; null if they are its own. */
        public function posedNumbersOf(element:ColladaElement):Vector.<Number>
        {
            return isAtRest ? null : _pose.numbersOf(String(element.index));
        }

        /**
         * What takes points of a joint to the scene, when no step is left.
         *
         * @param joint the joint's node
         * @param place where the skin is. Of several places of the joint, the nearest one counts
         * @param skin the skin's element, for the error
         * @throws ModelError if the joint is not in the scene
         */
        public function jointAt(joint:ColladaElement, place:ColladaPlace, skin:ColladaElement):AffineTransform
        {
            var places:Array = _places[joint.index];
            skin.refuseIf(places == null, "its joint \"" + shortened(joint.attribute("sid") || joint.id) + "\" is not in the scene");
            return place.nearestOf(places).transform;
        }

        private function visitSome():Boolean
        {
            for (var i:int = 0; i < ELEMENTS_PER_STEP && _place != null; i++)
            {
                var element:ColladaElement = _place.nextElement();
                if (element == null)
                {
                    _place.leave(_placeCount);
                    _place = _place.around;
                }
                else
                {
                    visit(element);
                }
            }
            return _place != null;
        }

        // The elements of a node are visited next.
        private function enter(node:ColladaElement):void
        {
            _place = new ColladaPlace(node, _place, _placeCount++);
            node.refuseIf(_place.depth > MAX_DEPTH, "its nodes are nested more than " + MAX_DEPTH + " deep");
            node.limits.spendElements(COUNT_PER_PLACING * (1 + node.children.length), node);
            (_places[node.index] ||= []).push(_place);
        }

        // Visits an element of the innermost node.
        private function visit(element:ColladaElement):void
        {
            switch (element.name)
            {
                case "instance_geometry":
                    instances.push(new ColladaInstance(element, document.meshOf(element.target("url", ["geometry"])), _place.transform));
                    break;
                case "instance_controller":
                    addController(element);
                    break;
                case "instance_node":
                    var inner:ColladaElement = element.target("url", ["node"]);
                    element.refuseIf(_place.isWithin(inner), "recursive instance_node: it places the node \"" + shortened(inner.id) + "\" within itself");
                    enter(inner);
                    break;
                case "node":
                    enter(element);
                    break;
                default:
                    var local:AffineTransform = transformOf(element);
                    if (local != null)
                    {
                        _place.addTransform(local);
                    }
            }
        }

        // The transform that an element is; null if it is none.
        private function transformOf(element:ColladaElement):AffineTransform
        {
            var numbers:Vector.<Number> = posedNumbersOf(element);
            return numbers == null ? element.toTransform() : ColladaTransform.of(element, numbers);
        }

        // Follows controllers down to the geometry, and finds their skins and morphs.
        private function addController(element:ColladaElement):void
        {
            var deformers:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            var target:ColladaElement = element.target("url", ["controller"]);
            while (target.name == "controller")
            {
                element.limits.spendElements(COUNT_PER_PLACING, element);
                var deformer:ColladaElement = target.child("skin") || target.requiredChild("morph");
                target = deformer.target("source", ["geometry", "controller"]);
                element.refuseIf(deformers.length == MAX_CONTROLLERS, "more than " + MAX_CONTROLLERS +
                        " controllers follow one another, or they refer to each other in a circle");
                deformers.push(deformer);
            }
            var mesh:ColladaMesh = document.meshOf(target);
            instances.push(new ColladaInstance(element, mesh, _place.transform, new ColladaDeformation(this, element, _place, mesh, deformers)));
        }
    }
}
