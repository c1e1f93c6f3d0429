package starlogo.models.collada
{
    import starlogo.data.keyOf;
    import starlogo.geometry.AffineTransform;
    import starlogo.models.files.shortened;
    import starlogo.models.text.TextWords;

    /** The nodes that are the joints of a COLLADA skin, for an element that places it. */
    internal final class ColladaSkeleton
    {
        private var _skin:ColladaSkin;
        private var _instance:ColladaElement;
        private var _nodes:Vector.<ColladaElement> = null;

        /**
         * @param skin the skin
         * @param instance the element that places it, with its skeletons
         */
        public function ColladaSkeleton(skin:ColladaSkin, instance:ColladaElement)
        {
            _skin = skin;
            _instance = instance;
        }

        /**
         * What moves points to the scene: by each joint, and last by joint -1.
         *
         * @param scene knows where joints are
         * @param place where the skin is in the scene
         * @throws ModelError if there is no such joint
         */
        public function paletteOf(scene:ColladaScene, place:ColladaPlace):Vector.<AffineTransform>
        {
            _nodes ||= jointsOf(_skin, _instance);
            _skin.element.limits.countNumbers(_nodes.length, _skin.element);
            var palette:Vector.<AffineTransform> = new Vector.<AffineTransform>();
            for (var i:int = 0; i < _nodes.length; i++)
            {
                palette.push(scene.jointAt(_nodes[i], place, _skin.element).after(_skin.inverses[i]).after(_skin.shape));
            }
            palette.push(_skin.shape);
            return palette;
        }

        private static function jointsOf(skin:ColladaSkin, instance:ColladaElement):Vector.<ColladaElement>
        {
            var names:ColladaAccessor = skin.names;
            var joints:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            // names are sids in the skeletons; other references are ids
            var nodes:Object = names.array.name == "Name_array" ? nodesBySid(instance) : null;
            for each (var name:String in names.words)
            {
                var node:ColladaElement = nodes == null ? instance.elementWith("node", name) : nodes[keyOf(name)];
                names.array.refuseIf(node == null, "there is no joint \"" + shortened(name) + "\" in the skeleton");
                joints.push(node);
            }
            return joints;
        }

        // The nodes of the skeletons, by their sids. The first node with a sid counts.
        private static function nodesBySid(instance:ColladaElement):Object
        {
            var nodes:Object = {};
            var pending:Vector.<ColladaElement> = skeletonsOf(instance).reverse();
            while (pending.length > 0)
            {
                var node:ColladaElement = pending.pop();
                instance.limits.countNumbers(1 + node.children.length, instance);
                nodes[keyOf(node.attribute("sid"))] ||= node;
                for each (var child:ColladaElement in node.childrenNamed("node").reverse())
                {
                    pending.push(child);
                }
            }
            return nodes;
        }

        // The roots of the skeletons. If none is named, the node or scene around all.
        private static function skeletonsOf(instance:ColladaElement):Vector.<ColladaElement>
        {
            var roots:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            for each (var skeleton:ColladaElement in instance.childrenNamed("skeleton"))
            {
                var url:String = TextWords.of(skeleton.text).join(" ");
                var root:ColladaElement = skeleton.elementAtUrl("node", url) || skeleton.elementAtUrl("visual_scene", url);
                skeleton.refuseIf(root == null, "there is no <node> with the id \"" + shortened(url.substr(1)) + "\"");
                roots.push(root);
            }
            for (root = instance; roots.length == 0; root = root.parent)
            {
                if (root.parent.name != "node" && root.parent.name != "visual_scene")
                {
                    roots.push(root);
                }
            }
            return roots;
        }
    }
}
