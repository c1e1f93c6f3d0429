package starlogo.libraries.cooked
{
    import flash.errors.EOFError;
    import flash.utils.ByteArray;
    import starlogo.data.zeroedInts;
    import starlogo.hierarchy.BoxRefit;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BoxTreeBuilder;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.VarInt;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Writes how a tree divides its primitives into a section of a cooked file, and restores the tree from that in steps. The boxes are not
     * written. They are computed again, in a fraction of the time that dividing takes. So the tree encloses the model, even if the bytes are
     * wrong. If the bytes are right, the tree equals the written one to the last bit.
     *
     * @private
     */
    public final class CookedTree extends StepSequence
    {
        private static const PRIMITIVES_PER_STEP:int = 1500;
        private static const NODES_PER_STEP:int = 300;

        // This is added to the axis of a node that is a leaf of the thesis's tree or below one.
        private static const BELOW:int = 3;
        private static const DIVISIONS:int = 2 * BELOW;

        /** Whether the bytes do not divide the primitives. Then no step is left. */
        public var isRefused:Boolean = false;

        private var _bytes:ByteArray;
        private var _tree:BoxTree;
        private var _maxDepth:int;

        /**
         * Creates the work that restores a tree.
         *
         * @param bytes what <code>write()</code> has written, read from its position on
         * @param tree without nodes; receives them, and the order of its primitives. It is not made if the bytes do not divide these primitives
         * @param maxDepth a node on this level is a leaf of the thesis
         */
        public function CookedTree(bytes:ByteArray, tree:BoxTree, maxDepth:int)
        {
            _bytes = bytes;
            _tree = tree;
            _maxDepth = maxDepth;
            call(addParts);
        }

        /**
         * Writes the order of the primitives. Each index takes 1, 2 or 4 bytes: see widthFor(). Then it writes the nodes from the root down, left
         * before right. A node without children is 0. Any other node is the sum of: 1; its axis; 3 if the node is a leaf of the thesis's tree or
         * below one; 6 times the number of primitives on its low side.
         */
        public static function write(tree:BoxTree):ByteArray
        {
            var out:ByteArray = CookedFile.newBytes();
            var width:int = widthFor(tree.primitives.length);
            for each (var primitive:int in tree.primitives)
            {
                for (var bits:int = 0; bits < 8 * width; bits += 8)
                {
                    out.writeByte(primitive >> bits);
                }
            }
            var waiting:Vector.<int> = new <int>[0];
            while (waiting.length > 0)
            {
                var node:int = waiting.pop();
                var left:int = tree.left[node];
                if (left == 0)
                {
                    VarInt.write(0, out);
                    continue;
                }
                VarInt.write(1 + tree.axisOf(node) + (tree.isLeafOrBelow(node) ? BELOW : 0) + DIVISIONS * (tree.endPrimitive[left] - tree.firstPrimitive[left]), out);
                waiting.push(left + 1, left);
            }
            return out;
        }

        /** The number of bytes for the index of a primitive. @param count the number of primitives */
        public static function widthFor(count:int):int
        {
            return count <= 0x100 ? 1 : (count <= 0x10000 ? 2 : 4);
        }

        private function addParts():void
        {
            var count:int = _tree.primitiveCount;
            var primitives:Vector.<int> = zeroedInts(count);
            var isListed:Vector.<Boolean> = new Vector.<Boolean>(count, true);
            var width:int = widthFor(count);
            // the nodes that still have to be read, the next one last
            var waiting:Vector.<int> = new <int>[0];
            slices(count, PRIMITIVES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end && !isRefused; i++)
                    {
                        var primitive:int = width == 1 ? _bytes.readUnsignedByte() : (width == 2 ? _bytes.readUnsignedShort() : _bytes.readInt());
                        // every primitive must come exactly once
                        if (primitive < 0 || primitive >= count || isListed[primitive])
                        {
                            isRefused = true;
                        }
                        else
                        {
                            isListed[primitive] = true;
                            primitives[i] = primitive;
                        }
                    }
                }).call(function():void
                {
                    _tree.primitives = primitives;
                    _tree.beginNodes();
                }).repeat(function():Boolean
                {
                    return readNodes(waiting);
                }).begin(function():Steps
                {
                    // computes the boxes
                    _tree.completeNodes();
                    return new BoxRefit(_tree);
                });
        }

        /** @inheritDoc */
        override public function step():Boolean
        {
            try
            {
                return !isRefused && super.step() && !isRefused;
            }
            catch (error:EOFError)
            {
                isRefused = true;
            }
            return false;
        }

        // Returns whether there are more.
        private function readNodes(waiting:Vector.<int>):Boolean
        {
            for (var i:int = 0; i < NODES_PER_STEP && waiting.length > 0 && !isRefused; i++)
            {
                isRefused = !readNode(waiting.pop(), VarInt.read(_bytes), waiting);
            }
            return waiting.length > 0;
        }

        // Reads a node, and adds its children to those that wait. Returns whether its code is right: the children must divide its primitives between
        // them, and a node without children must be small. Below the thesis's leaves, deep nodes must be divided as a BoxTreeBuilder divides them, so
        // that a file cannot make a tree as deep as the number of its primitives.
        private function readNode(node:int, code:int, waiting:Vector.<int>):Boolean
        {
            if (code <= 0)
            {
                return code == 0 && !BoxTreeBuilder.isLarge(_tree, node);
            }
            var first:int = _tree.firstPrimitive[node];
            var end:int = _tree.endPrimitive[node];
            var splitIndex:int = first + (code - 1) / DIVISIONS;
            var division:int = (code - 1) % DIVISIONS;
            var isWrong:Boolean = division < BELOW ? _tree.levelOf(node) >= _maxDepth
                : BoxTreeBuilder.isHalvedOnLevel(_tree.levelOf(node)) && splitIndex != (first + end) >> 1;
            if (isWrong || splitIndex <= first || splitIndex >= end)
            {
                return false;
            }
            var left:int = _tree.addChildren(node, division % BELOW, splitIndex, division >= BELOW);
            waiting.push(left + 1, left);
            return true;
        }
    }
}
