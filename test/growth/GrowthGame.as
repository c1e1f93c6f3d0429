package growth
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.agentAt;

    /** The agents of rows. */
    public final class GrowthGame
    {
        /** A GreatLand with the models "ball" and "cube", of width 1. */
        public static function land(prepareExact:Boolean = false):GreatLand
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.prepareExact = prepareExact;
            var ball:Model = BuiltInModel.sphere();
            greatLand.addModel(new Model("ball", ball.vertices, ball.triangles));
            greatLand.addModel(BuiltInModel.cube());
            return greatLand;
        }

        /** Agents of a shape in a square, from the origin on. Neighbours are apart by a distance. */
        public static function square(n:int, shape:String, apart:Number, z:Number = 0):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            var side:int = Math.ceil(Math.sqrt(n));
            for (var i:int = 0; i < n; i++)
            {
                agents.push(agentAt(shape, apart * (i % side), apart * int(i / side), z));
            }
            return agents;
        }
    }
}
